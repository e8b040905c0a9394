#include "cli/animate_command.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "cli/checkpoint.hpp"
#include "cli/exit_code.hpp"
#include "cli/say.hpp"
#include "cli/version.hpp"
#include "film/atomic_file.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

/// The shortest text that reads back as the same number.
std::string value_text(double value) { return fmt::format("{}", value); }

/// One frame: its render, and the ticket beside its image that says what it was made of.
class Frame {
public:
    Frame(const AnimateCommand& command, int number) : render_(command.render), options_(command.options), number_(number)
    {
        const fs::path image = frame_file(command.render.output, number);
        render_.output = image, ticket_ = fs::path(image).replace_extension(".done");
        for (const VaryingValue& value : command.vary) define(value.name, value.start + number * value.step);
        if (command.vary.empty()) define("frame", number);
        if (command.varying_seed) render_.settings.seed += static_cast<std::uint64_t>(number);
        render_.resume = fs::exists(checkpoint_of(image));
    }

    /// Its files are there, whole, and made of the same scene by the same program with the same options.
    bool done()
    {
        what_ = content();
        std::ifstream file(ticket_, std::ios::binary);
        return file && std::string(std::istreambuf_iterator<char>(file), {}) == what_ + sizes();
    }

    /// Returns the render's exit code.
    int render() const
    {
        std::error_code ignored;
        fs::remove(ticket_, ignored);
        const int code = run_render(render_);
        if (finished(code)) write_atomically(ticket_, what_ + sizes());
        return code;
    }

    static bool finished(int code) { return code == static_cast<int>(ExitCode::ok) || code == static_cast<int>(ExitCode::target_not_reached); }
    const fs::path& image() const { return render_.output; }

private:
    void define(const std::string& name, double value) { render_.load.definitions.insert_or_assign(name, value_text(value)); }

    std::string content() const
    {
        const Scene scene = load_scene(render_.scene, render_.load);
        return fmt::format("tyndall {}\nscene {:016x}\nframe {}, seed {}\n{}", version(), scene.hash, number_, render_.settings.seed, options_);
    }

    /// A line for each file, with its size; nothing for one that is missing.
    std::string sizes() const
    {
        std::string text;
        for (const char* ending : {".exr", ".png", ".json"}) {
            const fs::path file = fs::path(render_.output).replace_extension(ending);
            std::error_code missing;
            const auto bytes = fs::file_size(file, missing);
            if (!missing) text += fmt::format("{} {} bytes\n", file.filename().string(), bytes);
        }
        return text;
    }

    RenderCommand render_;
    fs::path ticket_;
    const std::string& options_;
    std::string what_;
    int number_;
};

void check(const AnimateCommand& command)
{
    if (!command.render.shard.whole()) throw UsageError("--shard divides one image; divide an animation by its --frames");
    if (!command.render.report.empty()) throw UsageError("--report names one file; the report of a frame lies beside its image");
    if (command.render.output.extension() == ".exr") throw UsageError("-o is the folder of the frames here, not an image");
    for (const VaryingValue& value : command.vary)
        if (command.render.load.definitions.contains(value.name)) throw UsageError(fmt::format("\"{}\" is given by -D and by --vary; give one", value.name));
    if (command.vary.empty() && command.render.load.definitions.contains("frame")) throw UsageError("\"frame\" is the number of the frame here; leave -D frame out, or use --vary");
}

}  // namespace

fs::path frame_file(const fs::path& folder, int frame) { return folder / fmt::format("frame_{:04}.exr", frame); }

int run_animate(AnimateCommand command)
{
    check(command);
    if (fs::is_directory(command.render.scene)) command.render.scene /= "scene.xml";
    fs::path& folder = command.render.output;
    if (folder.empty()) folder = (command.render.scene.filename() == "scene.xml" ? fs::absolute(command.render.scene).parent_path().filename() : command.render.scene.stem()).string() + "_frames";
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) throw IoError(fmt::format("{}: cannot be made a folder: {}; choose another with -o", folder.string(), fault.message()));
    int code = static_cast<int>(ExitCode::ok), done_before = 0;
    for (int number = command.first; number < command.end; ++number) {
        Frame frame(command, number);
        if (frame.done()) {
            ++done_before;
            continue;
        }
        say(stderr, "frame {} ({} of {})\n", number, number - command.first + 1, command.end - command.first);
        const int result = frame.render();
        if (!Frame::finished(result)) return result;
        code = std::max(code, result);
    }
    if (done_before > 0) say(stderr, "{} of {} frames were done before\n", done_before, command.end - command.first);
    return code;
}

}  // namespace tyndall
