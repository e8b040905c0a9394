#include "source_tree.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tyndall::house {
namespace {

std::vector<std::string> split_lines(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string read_text(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Index one past the literal that starts at `i` with a quote; a raw string ends at its own delimiter.
std::size_t end_of_literal(const std::string& text, std::size_t i)
{
    if (text[i] == '"' && i > 0 && text[i - 1] == 'R') {
        const std::size_t open = text.find('(', i);
        const std::string close = std::string(1, ')').append(text, i + 1, open - i - 1).append(1, '"');
        const std::size_t end = text.find(close, open);
        return end == std::string::npos ? text.size() : end + close.size();
    }
    const char quote = text[i];
    for (++i; i < text.size() && text[i] != quote && text[i] != '\n'; ++i)
        if (text[i] == '\\') ++i;
    return std::min(i + 1, text.size());
}

bool digit_separator(const std::string& text, std::size_t i)
{
    return text[i] == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1]));
}

bool on_include_line(const std::string& text, std::size_t i)
{
    const std::size_t newline = text.rfind('\n', i);
    const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
    return text.substr(start, i - start).find("#include") != std::string::npos;
}

void blank(std::string& text, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to; ++i)
        if (text[i] != '\n') text[i] = ' ';
}

}  // namespace

std::string blank_comments_and_literals(const std::string& text)
{
    std::string out = text;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        if (text.compare(i, 2, "//") == 0) {
            end = std::min(text.find('\n', i), text.size());
            blank(out, i, end);
        } else if (text.compare(i, 2, "/*") == 0) {
            const std::size_t close = text.find("*/", i + 2);
            end = close == std::string::npos ? text.size() : close + 2;
            blank(out, i, end);
        } else if ((text[i] == '"' || text[i] == '\'') && !digit_separator(text, i)) {
            end = end_of_literal(text, i);
            if (!on_include_line(text, i)) blank(out, i + 1, end - 1);
        }
        i = end;
    }
    return out;
}

std::vector<SourceFile> read_files(const fs::path& root, std::string_view folder, const std::vector<std::string_view>& endings)
{
    std::vector<SourceFile> files;
    if (!fs::is_directory(root / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string name = entry.path().filename().string();
        const bool wanted = std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return name.ends_with(e); });
        if (!entry.is_regular_file() || !wanted) continue;
        const std::string text = read_text(entry.path());
        files.push_back({fs::relative(entry.path(), root).generic_string(), split_lines(text), split_lines(blank_comments_and_literals(text))});
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::vector<SourceFile> read_sources(const fs::path& root)
{
    std::vector<SourceFile> all;
    for (const char* folder : {"kernels", "host", "tests", "bench"})
        for (SourceFile& file : read_files(root, folder, {".cpp", ".hpp", ".h", ".c", ".cl"})) all.push_back(std::move(file));
    return all;
}

std::string violation(const SourceFile& file, std::size_t line_index, const std::string& message)
{
    return file.path + ":" + std::to_string(line_index + 1) + ": " + message;
}

TemporaryFolder::TemporaryFolder()
{
    std::string name = (fs::temp_directory_path() / "tyndall_house_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder like " + name);
    path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& relative, const std::string& text) const
{
    fs::create_directories((path_ / relative).parent_path());
    std::ofstream(path_ / relative, std::ios::binary) << text;
}

}  // namespace tyndall::house
