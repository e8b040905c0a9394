#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>

#include "rules.hpp"

namespace tyndall::house {
namespace {

const std::set<std::string> top_level = {"CMakeLists.txt", "CMakePresets.json", "CITATION.cff", "LICENSE", "README.md", "bench", "host",
                                         "kernels",        "scenes",            "tests",   "build",     "out"};

std::vector<SourceFile> read_documents(const fs::path& root)
{
    std::vector<SourceFile> documents;
    for (const char* folder : {"host", "kernels", "scenes", "tests", "bench", ".github"})
        for (SourceFile& file : read_files(root, folder, {".md"})) documents.push_back(std::move(file));
    for (SourceFile& file : read_files(root, ".", {"README.md"}))
        if (file.path == "README.md") documents.push_back(std::move(file));
    return documents;
}

bool leads_somewhere(const fs::path& root, const fs::path& from, std::string target)
{
    target = target.substr(0, target.find('#'));
    return target.empty() || fs::exists(root / from.parent_path() / target);
}

void check_links(const fs::path& root, const SourceFile& file, std::size_t i, Violations& found)
{
    static const std::regex link(R"(\]\(([^)\s]+)\))");
    for (std::sregex_iterator match(file.lines[i].begin(), file.lines[i].end(), link), end; match != end; ++match) {
        const std::string target = (*match)[1];
        if (target.find("://") == std::string::npos && !leads_somewhere(root, file.path, target))
            found.push_back(violation(file, i, "the link to " + target + " leads nowhere"));
    }
}

/// Paths from the repository's root as README files name them; those with a placeholder such as <scene> are left out.
void check_paths(const fs::path& root, const SourceFile& file, std::size_t i, Violations& found)
{
    static const std::regex path(R"((^|[`\s])((kernels|host|scenes|tests|bench)/[\w./<>*{}-]*))");
    for (std::sregex_iterator match(file.lines[i].begin(), file.lines[i].end(), path), end; match != end; ++match) {
        std::string target = (*match)[2];
        if (target.find_first_of("<*{") != std::string::npos) continue;
        while (target.ends_with('.')) target.pop_back();
        if (!fs::exists(root / target)) found.push_back(violation(file, i, "there is no " + target));
    }
}

bool same_bytes(const fs::path& a, const fs::path& b)
{
    std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
    using Iterator = std::istreambuf_iterator<char>;
    return first && second && std::equal(Iterator(first), Iterator(), Iterator(second), Iterator());
}

bool is_geometry(const fs::path& file)
{
    const std::string extension = file.extension().string();
    return extension == ".obj" || extension == ".ply" || extension == ".vol";
}

void check_geometry(const fs::path& root, const fs::path& scene, Violations& found)
{
    const std::string name = fs::relative(scene, root).generic_string();
    const TemporaryFolder written;
    if (fs::exists(scene / "make_geometry.py")) {
        const std::string command = "python3 -B '" + (scene / "make_geometry.py").string() + "' '" + written.path().string() + "'";
        if (std::system(command.c_str()) != 0) found.push_back(name + ": failed: " + command);
    }
    for (const auto& entry : fs::directory_iterator(scene))
        if (is_geometry(entry.path()) && !same_bytes(entry.path(), written.path() / entry.path().filename()))
            found.push_back(name + "/" + entry.path().filename().string() + ": is not what make_geometry.py writes; run it and commit the result");
    for (const auto& entry : fs::directory_iterator(written.path()))
        if (!fs::exists(scene / entry.path().filename()))
            found.push_back(name + ": make_geometry.py writes " + entry.path().filename().string() + ", which is not there");
}

}  // namespace

Violations strangers_at_the_top(const fs::path& root)
{
    Violations found;
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with('.') && !top_level.contains(name)) found.push_back(name + ": does not belong at the top of the repository");
    }
    return found;
}

Violations dead_links(const fs::path& root)
{
    Violations found;
    for (const SourceFile& file : read_documents(root))
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            check_links(root, file, i, found);
            if (file.path.ends_with("README.md")) check_paths(root, file, i, found);
        }
    return found;
}

Violations pages_that_nobody_finds(const fs::path& root)
{
    std::string index;
    for (const SourceFile& file : read_files(root, "host/docs", {"README.md"}))
        if (file.path == "host/docs/README.md")
            for (const std::string& line : file.lines) index += line;
    Violations found;
    for (const SourceFile& file : read_files(root, "host/docs", {".md"})) {
        const fs::path path = file.path;
        if (path.parent_path() == "host/docs" && path.filename() != "README.md" && index.find("](" + path.filename().string() + ")") == std::string::npos)
            found.push_back(file.path + ": is not linked from host/docs/README.md");
    }
    return found;
}

Violations tests_that_are_not_there(const fs::path& root)
{
    static const std::regex definition(R"(\bTEST(_F|_P)?\((\w+), (\w+)\))"), mention(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
    std::set<std::string> tests;
    for (const SourceFile& file : read_files(root, "tests", {"_test.cpp"}))
        for (const std::string& line : file.lines)
            for (std::sregex_iterator match(line.begin(), line.end(), definition), end; match != end; ++match) tests.insert((*match)[2].str() + "." + (*match)[3].str());
    Violations found;
    for (const SourceFile& file : read_files(root, "host/docs", {"faults.md"}))
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            for (std::sregex_iterator match(file.lines[i].begin(), file.lines[i].end(), mention), end; match != end; ++match)
                if (!tests.contains((*match)[1])) found.push_back(violation(file, i, "there is no test " + (*match)[1].str()));
    return found;
}

Violations scenes_not_reproduced(const fs::path& root)
{
    Violations found;
    for (const auto& entry : fs::directory_iterator(root / "scenes")) {
        if (!entry.is_directory()) continue;
        const std::string name = fs::relative(entry.path(), root).generic_string();
        for (const char* file : {"scene.xml", "README.md"})
            if (!fs::exists(entry.path() / file)) found.push_back(name + ": has no " + file);
        check_geometry(root, entry.path(), found);
    }
    return found;
}

}  // namespace tyndall::house
