/// What documents promise to hold completely.
#include <fstream>
#include <regex>
#include <set>

#include "rules.hpp"

namespace tyndall::house {
namespace {

/// The words between quotes that a line asks the file for: parameters, roles of nested objects, types.
std::set<std::string> asked_in(const std::string& line)
{
    static const std::regex parameter(R"re((properties\.\w+|read_\w+)\((builder, properties, )?"(\w+)")re"), types(R"re((refuse_type|choice)\((.*)\))re"), word(R"re("(\w+)")re");
    std::set<std::string> words;
    for (std::sregex_iterator match(line.begin(), line.end(), parameter), end; match != end; ++match) words.insert((*match)[3]);
    for (std::sregex_iterator match(line.begin(), line.end(), types), end; match != end; ++match) {
        const std::string list = (*match)[2];
        for (std::sregex_iterator name(list.begin(), list.end(), word); name != end; ++name) words.insert((*name)[1]);
    }
    return words;
}

/// What the pattern's group matches in the first line that it matches; "" if there is none.
std::string first_match(const fs::path& file, const std::regex& pattern)
{
    std::ifstream stream(file);
    std::smatch match;
    for (std::string line; std::getline(stream, line);)
        if (std::regex_search(line, match, pattern)) return match[1];
    return "";
}

}  // namespace

Violations elements_without_a_page(const fs::path& root)
{
    static const std::regex word(R"(\w+)");
    std::set<std::string> documented;
    for (const SourceFile& file : read_files(root, "host/docs", {"scenes.md"}))
        for (const std::string& line : file.lines)
            for (std::sregex_iterator match(line.begin(), line.end(), word), end; match != end; ++match) documented.insert(match->str());
    Violations found;
    for (const SourceFile& file : read_files(root, "host/scene", {".cpp"}))
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            for (const std::string& name : asked_in(file.lines[i]))
                if (!documented.contains(name)) found.push_back(violation(file, i, "reads \"" + name + "\", which host/docs/scenes.md does not tell of"));
    return found;
}

Violations versions_that_differ(const fs::path& root)
{
    const std::string version = first_match(root / "CMakeLists.txt", std::regex(R"(^project\(tyndall VERSION (\S+))"));
    Violations found;
    const std::pair<std::string, std::string> others[] = {{"CITATION.cff", first_match(root / "CITATION.cff", std::regex(R"(^version: (\S+))"))},
                                                          {"host/docs/changelog.md", first_match(root / "host/docs/changelog.md", std::regex(R"(^## \[([^\]]+)\])"))}};
    for (const auto& [file, other] : others)
        if (version.empty() || other != version) found.push_back(file + ": is of version \"" + other + "\", CMakeLists.txt of \"" + version + "\"");
    return found;
}

}  // namespace tyndall::house
