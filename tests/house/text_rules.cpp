#include <algorithm>
#include <regex>

#include "rules.hpp"

namespace tyndall::house {
namespace {

constexpr std::size_t longest_source = 300;
constexpr std::size_t longest_cmake = 99;
constexpr std::size_t longest_function = 40;

/// What an opening brace at file, namespace or class scope opens, told from the text between the last ';', '{' or '}' and it.
enum class Opens { scope, function, other };

Opens what_opens(const std::string& head)
{
    static const std::regex scope(R"(^\s*(template\s*<.*>\s*)?(inline\s+)?(typedef\s+)?(namespace|struct|class|union|enum|extern)\b)");
    static const std::regex parameters(R"(\))");
    static const std::regex initialiser(R"(=\s*$|=\s*[^()]*$)");
    if (std::regex_search(head, scope) && !std::regex_search(head, parameters)) return Opens::scope;
    if (!std::regex_search(head, parameters) || std::regex_search(head, initialiser)) return Opens::other;
    return Opens::function;
}

/// Walks over the braces of one file and notes the functions that are too long.
class FunctionMeter {
public:
    FunctionMeter(const SourceFile& file, Violations& found) : file_(file), found_(found) {}

    void run()
    {
        for (line_ = 0; line_ < file_.code.size(); ++line_) {
            if (skip_directive()) continue;
            for (char c : file_.code[line_]) step(c);
            step('\n');
        }
    }

private:
    bool skip_directive()
    {
        const std::string& line = file_.code[line_];
        const std::size_t first = line.find_first_not_of(" \t");
        const bool directive = continued_ || (first != std::string::npos && line[first] == '#');
        continued_ = directive && !line.empty() && line.back() == '\\';
        return directive;
    }

    void step(char c)
    {
        if (c == '{') return open();
        if (c == '}') return close();
        if (inside_ > 0) return;
        if (c == ';') return head_.clear();
        if (head_.find_first_not_of(" \n") == std::string::npos) head_line_ = line_;
        head_ += c == '\n' ? ' ' : c;
    }

    void open()
    {
        if (inside_ > 0) {
            ++inside_;
            return;
        }
        const Opens kind = what_opens(head_);
        if (kind != Opens::scope) {
            inside_ = 1;
            measured_ = kind == Opens::function;
            start_ = head_line_;
        }
        head_.clear();
    }

    void close()
    {
        head_.clear();
        if (inside_ == 0 || --inside_ > 0 || !measured_) return;
        const std::size_t length = line_ - start_ + 1;
        if (length > longest_function)
            found_.push_back(violation(file_, start_, "function of " + std::to_string(length) + " lines; at most " +
                                                          std::to_string(longest_function) + ": give its steps names"));
    }

    const SourceFile& file_;
    Violations& found_;
    std::string head_;
    std::size_t line_ = 0, head_line_ = 0, start_ = 0;
    int inside_ = 0;
    bool measured_ = false, continued_ = false;
};

void check_length(const SourceFile& file, std::size_t longest, Violations& found)
{
    if (file.lines.size() > longest)
        found.push_back(file.path + ": " + std::to_string(file.lines.size()) + " lines; at most " + std::to_string(longest));
}

/// Whether line `i` is the `#ifndef X` of an include guard or of a build option's default: the next directive is `#define X`.
bool only_defines(const SourceFile& file, std::size_t i)
{
    static const std::regex opening(R"(^\s*#\s*ifndef\s+(\w+))");
    std::smatch match;
    if (!std::regex_search(file.code[i], match, opening)) return false;
    const auto next = std::find_if(file.code.begin() + static_cast<std::ptrdiff_t>(i) + 1, file.code.end(),
                                   [](const std::string& line) { return line.find('#') != std::string::npos; });
    return next != file.code.end() && std::regex_search(*next, std::regex(R"(^\s*#\s*define\s+)" + match[1].str() + R"(\b)"));
}

void find_in(const std::vector<SourceFile>& files, const std::regex& pattern, const std::string& message, Violations& found)
{
    for (const SourceFile& file : files)
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_search(file.lines[i], match, pattern)) found.push_back(violation(file, i, match.str() + message));
        }
}

}  // namespace

Violations files_too_long(const fs::path& root)
{
    Violations found;
    for (const SourceFile& file : read_sources(root)) check_length(file, longest_source, found);
    for (const char* folder : {"kernels", "host", "tests", "bench"})
        for (const SourceFile& file : read_files(root, folder, {"CMakeLists.txt", ".cmake"})) check_length(file, longest_cmake, found);
    return found;
}

Violations functions_too_long(const fs::path& root)
{
    Violations found;
    for (const SourceFile& file : read_sources(root)) FunctionMeter(file, found).run();
    return found;
}

Violations conditional_compilation_in_kernels(const fs::path& root)
{
    static const std::regex conditional(R"(^\s*#\s*(if|ifdef|ifndef|elif)\b)");
    Violations found;
    for (const SourceFile& file : read_files(root, "kernels", {".h", ".hpp", ".cl"})) {
        if (file.path.starts_with("kernels/dialect")) continue;
        for (std::size_t i = 0; i < file.code.size(); ++i)
            if (std::regex_search(file.code[i], conditional) && !only_defines(file, i))
                found.push_back(violation(file, i, "ask `if (FEATURE)` instead, so that every variant is compiled and checked"));
    }
    return found;
}

Violations approximate_arithmetic(const fs::path& root)
{
    Violations found;
    static const std::regex function(R"(\b(native|half)_(cos|divide|exp|exp2|exp10|log|log2|log10|powr|recip|rsqrt|sin|sqrt|tan)\b)");
    find_in(read_files(root, "kernels", {".h", ".hpp", ".cl"}), function, ": its error is unbounded; use the dialect's function", found);
    static const std::regex option(
        "(-cl-fast-relaxed-math|-cl-unsafe-math-optimizations|-cl-mad-enable|-cl-finite-math-only|-cl-no-signed-zeros|-cl-denorms-are-zero|"
        "-ffast-math|-Ofast|-funsafe-math-optimizations|-ffinite-math-only|-fassociative-math|-freciprocal-math|-ffp-contract=(fast|on))"
        "(?!.*// --math fast)");  // what a user asked for by that name
    for (const char* folder : {"kernels", "host", "bench"})
        find_in(read_files(root, folder, {".cpp", ".hpp", ".h", ".cl", "CMakeLists.txt", ".cmake"}), option, ": changes results", found);
    return found;
}

}  // namespace tyndall::house
