#include "pipeline/render_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "film/atomic_file.hpp"
#include "report/report_bytes.hpp"
#include "scene/byte_stream.hpp"

namespace tyndall {

template <class Stream, class Self>
void fields(Stream& stream, Self& setting)
    requires std::is_same_v<std::remove_const_t<Self>, StateSetting>
{
    stream(setting.name), stream(setting.value);
}

namespace {

constexpr std::array<char, 16> magic{'t', 'y', 'n', 'd', 'a', 'l', 'l', '-', 's', 't', 'a', 't', 'e', '/', '1', '\n'};
constexpr std::size_t name_size = 14;  ///< of the magic, without its version

/// What stands before and after the content.
struct Frame {
    std::array<char, 16> magic{};
    std::uint64_t content_bytes = 0;
};
static_assert(sizeof(Frame) == 24);

template <class Stream, class Self>
void fields(Stream& stream, Self& state)
    requires std::is_same_v<std::remove_const_t<Self>, RenderState>
{
    stream(state.settings);
    stream(state.shard.number), stream(state.shard.of), stream(state.range.first), stream(state.range.end), stream(state.run_passes), stream(state.finished);
    stream(state.window.x), stream(state.window.y), stream(state.window.full_width), stream(state.window.full_height);
    for (std::size_t l = 0; l < layer_count; ++l) {
        bool asked = state.asked.contains(static_cast<Layer>(l));
        stream(asked);
        if constexpr (!std::is_const_v<Self>)
            if (asked) state.asked.add(static_cast<Layer>(l));
    }
}

std::string contents(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw SceneError("cannot be read");
    return bytes;
}

/// The bytes between frame and checksum.
std::span<const std::byte> checked_content(const std::string& bytes)
{
    Frame frame;
    if (bytes.size() < sizeof(Frame) || std::memcmp(bytes.data(), magic.data(), name_size) != 0) throw SceneError("is no checkpoint or shard of Tyndall");
    std::memcpy(&frame, bytes.data(), sizeof(Frame));
    if (frame.magic != magic) throw SceneError("is a state file of another format version, which this version of Tyndall cannot read");
    const std::uint64_t held = bytes.size() - sizeof(Frame);
    if (frame.content_bytes == 0) throw SceneError("is damaged: its length is missing");
    if (held < sizeof(std::uint64_t) || held - sizeof(std::uint64_t) < frame.content_bytes)
        throw SceneError(fmt::format("is cut short: {} bytes of {}", bytes.size(), frame.content_bytes + sizeof(Frame) + sizeof(std::uint64_t)));
    const auto content = std::as_bytes(std::span(bytes)).subspan(sizeof(Frame), static_cast<std::size_t>(frame.content_bytes));
    std::uint64_t expected = 0;
    std::memcpy(&expected, content.data() + content.size(), sizeof expected);
    Checksum sum;
    sum.add(content);
    if (held != frame.content_bytes + sizeof(std::uint64_t) || sum.value() != expected) throw SceneError("is damaged: its checksum does not fit");
    return content;
}

/// Do the films hold what the rest says?
void check(const RenderState& state)
{
    int next = state.range.first;
    bool good = state.range.first >= 0 && !(state.shard.whole() && state.films.size() != 1);
    for (std::size_t f = 0; f < state.films.size(); ++f) {
        const Film& film = state.films[f];
        good = good && film.first_pass() == next && film.same_kind(state.films[0]);
        good = good && (state.shard.whole() || (film.passes() > 0 && film.passes() <= film.block_passes() && (f + 1 == state.films.size() || film.passes() == film.block_passes())));
        next += film.passes();
    }
    if (!good || (state.finished && state.range.end > 0 && next != state.range.end)) throw SceneError("is damaged: what it holds does not fit together");
}

}  // namespace

int RenderState::passes() const
{
    int passes = 0;
    for (const Film& film : films) passes += film.passes();
    return passes;
}

PassRange passes_of(const ShardNumber& shard, int run_passes, int block_passes)
{
    if (shard.whole()) return {0, run_passes};
    const std::int64_t blocks = (std::int64_t(run_passes) + block_passes - 1) / block_passes;
    const auto at = [&](std::int64_t i) { return static_cast<int>(std::min<std::int64_t>(blocks * i / shard.of * block_passes, run_passes)); };
    return {at(shard.number - 1), at(shard.number)};
}

void write_state(const std::filesystem::path& file, const RenderState& state)
{
    AtomicFile out(file);
    out.seek(sizeof(Frame));
    Checksum sum;
    std::string buffer;
    const auto flush = [&] { out.write(buffer.data(), buffer.size()), sum.add(std::as_bytes(std::span(buffer))), buffer.clear(); };
    ByteWriter writer([&](std::span<const std::byte> bytes) {
        buffer.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (buffer.size() > std::size_t(1) << 20) flush();
    });
    fields(writer, state);
    save(writer, state.report);
    writer(std::uint64_t(state.films.size()));
    for (const Film& film : state.films) film.save(writer);
    flush();
    const Frame frame{magic, out.position() - sizeof(Frame)};
    const std::uint64_t value = sum.value();
    out.write(&value, sizeof value);
    out.seek(0);
    out.write(&frame, sizeof frame);
    out.commit();
}

RenderState read_state(const std::filesystem::path& file)
try {
    const std::string bytes = contents(file);
    ByteReader reader(checked_content(bytes));
    RenderState state;
    fields(reader, state);
    state.report = load_report(reader);
    std::uint64_t films = 0;
    reader(films);
    for (std::uint64_t i = 0; i < films; ++i) state.films.push_back(Film::load(reader));
    if (reader.left() > 0) throw SceneError("is damaged: there are bytes behind its end");
    check(state);
    return state;
} catch (const SceneError& error) {
    throw SceneError(fmt::format("{}: {}", file.string(), error.what()));
}

std::vector<std::string> differences(const std::vector<StateSetting>& here, const std::vector<StateSetting>& there, const std::string& there_name)
{
    std::vector<std::string> sentences;
    const auto value_in = [](const std::vector<StateSetting>& settings, const std::string& name) {
        const auto found = std::ranges::find(settings, name, &StateSetting::name);
        return found == settings.end() ? std::string("not given") : found->value;
    };
    const auto compare = [&](const std::string& name) {
        const std::string a = value_in(here, name), b = value_in(there, name);
        if (a != b) sentences.push_back(fmt::format("{} is {} here and {} in {}", name, a, b, there_name));
    };
    for (const auto& setting : here) compare(setting.name);
    for (const auto& setting : there)
        if (std::ranges::find(here, setting.name, &StateSetting::name) == here.end()) compare(setting.name);
    return sentences;
}

}  // namespace tyndall
