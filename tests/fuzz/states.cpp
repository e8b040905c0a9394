/// Checkpoints and shards. Their checksum would hide all that is behind it: content gets the frame that host/docs/farm.md describes.
#include <cstring>
#include <vector>

#include "memory_file.hpp"
#include "pipeline/merge_shards.hpp"
#include "pipeline/render_state.hpp"
#include "scene/byte_stream.hpp"
#include "targets.hpp"
#include "tyndall/error.hpp"

namespace tyndall::fuzz {
namespace {

void append(std::vector<std::uint8_t>& file, const void* data, std::size_t size)
{
    const auto* first = static_cast<const std::uint8_t*>(data);
    file.insert(file.end(), first, first + size);
}

/// The state file with that content.
std::vector<std::uint8_t> framed(Bytes content)
{
    std::vector<std::uint8_t> file;
    append(file, "tyndall-state/1\n", 16);
    const std::uint64_t size = content.size();
    append(file, &size, sizeof size);
    append(file, content.data(), content.size());
    Checksum sum;
    sum.add(std::as_bytes(content));
    const std::uint64_t value = sum.value();
    append(file, &value, sizeof value);
    return file;
}

std::vector<std::uint8_t> state_file(Bytes bytes)
{
    if (bytes.empty()) return {};
    const Bytes rest = bytes.subspan(1);
    return bytes[0] % 2 ? framed(rest) : std::vector<std::uint8_t>(rest.begin(), rest.end());
}

void check_state(const RenderState& state)
{
    require(state.passes() >= 0, "passes are counted");
    for (const Film& film : state.films) require(film.width() >= 1 && film.height() >= 1, "a film has a pixel");
}

}  // namespace

void checkpoint(Bytes bytes)
{
    const MemoryFile file(state_file(bytes));
    try {
        check_state(read_state(file.path()));
    } catch (const SceneError&) {
    }
}

void shards(Bytes bytes)
{
    std::uint32_t size = 0;
    if (bytes.size() < sizeof size) return;
    std::memcpy(&size, bytes.data(), sizeof size);
    const Bytes both = bytes.subspan(sizeof size);
    if (size > both.size()) return;
    const MemoryFile first(framed(both.first(size))), second(framed(both.subspan(size)));
    try {
        check_state(merge_shards({first.path(), second.path()}, false));
    } catch (const SceneError&) {
    }
}

}  // namespace tyndall::fuzz
