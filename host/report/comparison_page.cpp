#include "report/comparison_page.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace tyndall {
namespace {

std::string_view text_of(std::string_view path)
{
    for (const PageFile& file : page_files())
        if (file.path == path) return {file.text, file.size};
    throw std::logic_error("the program lacks " + std::string(path));
}

/// In a JSON string "<" and its escape mean the same; outside strings it does not occur.
std::string without_markup(std::string_view json)
{
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        if (c == '<') text += "\\u003c";
        else text += c;
    }
    return text;
}

void replace(std::string& page, std::string_view place, std::string_view text)
{
    const std::size_t at = page.find(place);
    if (at == std::string::npos) throw std::logic_error("the page has no place for " + std::string(place));
    page.replace(at, place.size(), text);
}

}  // namespace

std::string comparison_page(std::string_view data)
{
    std::string page(text_of("page.html")), scripts;
    std::vector<std::string_view> names;
    for (const PageFile& file : page_files())
        if (const std::string_view path = file.path; path.ends_with(".js")) names.push_back(path);
    std::ranges::sort(names);  // 1_..., 2_...: in the order in which they need each other
    for (const std::string_view name : names) scripts.append(text_of(name)).append("\n");
    replace(page, "/*style*/", text_of("page.css"));
    replace(page, "/*scripts*/", scripts);
    replace(page, "/*data*/", without_markup(data));
    return page;
}

}  // namespace tyndall
