#include "device/kernel_source.hpp"

#include <set>
#include <sstream>

#include "kernels/embedded_kernels.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

std::string text_of(const std::string& path)
{
    for (const EmbeddedKernel& file : embedded_kernels())
        if (path == file.path) return {file.text, file.size};
    throw BuildError("kernel file \"" + path + "\" is not part of this program; rebuild it");
}

/// The quoted name of an #include line, or nothing.
std::string included_name(const std::string& line)
{
    const std::string start = "#include \"";
    if (line.rfind(start, 0) != 0) return {};
    return line.substr(start.size(), line.find('"', start.size()) - start.size());
}

struct Flattener {
    const std::map<std::string, std::string>& substitutions;
    std::set<std::string> done;
    std::string text;

    void add(const std::string& path, int depth)
    {
        if (depth > 32) throw BuildError("kernel includes nest deeper than 32 at \"" + path + "\"");
        if (!done.insert(path).second) return;
        text += "#line 1 \"" + path + "\"\n";
        std::istringstream lines(text_of(path));
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            const std::string name = included_name(line);
            if (name.empty()) {
                text += line + "\n";
                continue;
            }
            const auto found = substitutions.find(name);
            add(found == substitutions.end() ? name : found->second, depth + 1);
            text += "#line " + std::to_string(number + 1) + " \"" + path + "\"\n";
        }
    }
};

}  // namespace

std::string flattened_kernel(const std::string& path, const std::map<std::string, std::string>& substitutions)
{
    Flattener flattener{substitutions, {}, {}};
    flattener.add(path, 0);
    return flattener.text;
}

}  // namespace tyndall
