#pragma once
/// The repository as the house rules see it: its files, line by line.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::house {

namespace fs = std::filesystem;

struct SourceFile {
    std::string path;                ///< relative to the repository root, with '/'
    std::vector<std::string> lines;  ///< as they are
    std::vector<std::string> code;   ///< the same lines with comments, and the insides of string and character literals, blanked
};

/// Every file below `folder` of the repository whose name ends in one of `endings`, sorted by path; empty if there is no such folder.
std::vector<SourceFile> read_files(const fs::path& root, std::string_view folder, const std::vector<std::string_view>& endings);

/// All C++, OpenCL C and header files of kernels, host, tests and bench.
std::vector<SourceFile> read_sources(const fs::path& root);

/// The text with comments, and the insides of literals, replaced by blanks; newlines stay. `#include "x"` keeps its name.
std::string blank_comments_and_literals(const std::string& text);

/// "path:line: message", the form of every violation.
std::string violation(const SourceFile& file, std::size_t line_index, const std::string& message);

/// A fresh folder under the system's temporary folder, removed again at the end.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }
    /// Writes a file below the folder, with the folders that it needs.
    void write(const std::string& relative, const std::string& text) const;

private:
    fs::path path_;
};

}  // namespace tyndall::house
