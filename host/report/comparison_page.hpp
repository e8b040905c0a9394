#pragma once
/// One HTML file that shows a comparison: style, script and data inside, nothing to fetch (host/report/page).
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tyndall {

/// A file of host/report/page, carried by the program.
struct PageFile {
    const char* path;
    const char* text;
    std::size_t size;
};
const std::span<const PageFile> page_files();

/// The page around `data`, JSON of the schema "tyndall-comparison/1" with images. Nothing in the data can end the element that holds it or add another one.
std::string comparison_page(std::string_view data);

}  // namespace tyndall
