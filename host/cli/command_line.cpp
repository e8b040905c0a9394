#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "cli/animate_options.hpp"
#include "cli/compare_options.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_command.hpp"
#include "cli/interrupt.hpp"
#include "cli/kernel_cache.hpp"
#include "cli/list_commands.hpp"
#include "cli/manual.hpp"
#include "cli/option_sources.hpp"
#include "cli/render_command.hpp"
#include "cli/render_line.hpp"
#include "cli/render_options.hpp"
#include "cli/say.hpp"
#include "cli/selftest_command.hpp"
#include "cli/version.hpp"
#include "device/opencl_loader.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// Everything that can be asked for.
struct Request {
    RenderCommand render;
    AnimateCommand animate;
    ExplainCommand explain;
    CompareCommand compare;
    MergeCommand merge;
    InfoCommand info;
    DevicesCommand devices;
    SelftestCommand selftest;
    BenchCommand bench;
    std::string shell;  ///< of completion
    std::string config;           ///< file with values of options
    bool print_config = false;
};

constexpr const char* examples = R"(Examples:
  tyndall render scene.xml                       16 passes into scene.exr, .png, .json
  tyndall render scene.xml -o fog.exr --time 2m  what two minutes allow
  tyndall render scene.xml --method path         the same image by path tracing
  tyndall explain scene.xml                      what would be simulated, why, and how long it takes
  tyndall compare a.exr b.exr --tolerance 1%     how far an image is from another
  tyndall compare scene.xml --times 1,6 -o page  methods at equal time, as a page to look at
  tyndall render scene.xml -p 400 --shard 3/16   a part of the passes, for another machine
  tyndall merge *.shard -o fog.exr               one image from all the parts
  tyndall animate scene.xml --frames 0:24        a picture for every value of the scene's <default> "frame"
  tyndall info scene.xml                         what the file says
  tyndall devices                                where it can run
  tyndall bench                                  how fast that is
  tyndall bench --accuracy -o dials              what every option is worth in accuracy for the same time
  tyndall selftest                               whether the device computes as it must
)";

constexpr const char* compare_examples = R"(Examples:
  tyndall compare fog.exr reference.exr --tolerance 1%
  tyndall compare scene.xml --times 1,6,1m -o page
  tyndall compare scene.xml --methods vrl --samplers paper,table --lights 64,256
  tyndall compare scene.xml --reference reference.exr --layer media_to_media --repeats 5
)";

constexpr const char* render_examples = R"(Examples:
  tyndall render scene.xml -o fog.exr --passes 64
  tyndall render scene.xml --time 2m --resolution 320x240
  tyndall render scene.xml --layer single,media_to_media --crop 100,50,64,64
  tyndall render scene.xml -D density=2 --seed 7 --no-timestamps
)";

constexpr const char* animate_examples = R"(Examples:
  tyndall animate scenes/turning_light --frames 0:24 -o turning
  tyndall animate scene.xml --frames 0:100 --time 1m --seed-per-frame fixed
  tyndall animate scene.xml --frames 0:24 --vary angle=0:15 --vary height=1:.25
)";

/// Help with the examples first, then usage and options.
class ExamplesFirst : public CLI::Formatter {
public:
    ExamplesFirst() { column_width(32); }
    std::string make_description(const CLI::App* app) const override
    {
        const std::string& name = app->get_name();
        const char* shown = name == "render" ? render_examples : name == "compare" ? compare_examples : name == "animate" ? animate_examples : app->get_parent() ? "" : examples;
        return app->get_description() + "\n\n" + shown + (*shown ? "\n" : "");
    }
};

/// Options of every command that has any.
void add_to_all(CLI::App& app, Request& request)
{
    for (CLI::App* command : app.get_subcommands(nullptr)) {
        if (command->get_name() == "man" || command->get_name() == "completion") continue;
        command->add_option("--config", request.config, "values of options, one a line: name = value; the command line and TYNDALL_... win over it")->type_name("FILE")->envname("TYNDALL_CONFIG");
        command->add_flag("--print-config", request.print_config, "print every option with its value and where that is from, and exit");
    }
}

void declare(CLI::App& app, Request& request)
{
    app.formatter(std::make_shared<ExamplesFirst>());
    app.set_help_flag("-h,--help", "print this and exit");
    app.set_version_flag("--version", [] { return version_text(opencl_loader()); }, "print version, commit and libraries, and exit");
    app.require_subcommand(1);
    auto* render = app.add_subcommand("render", "Renders a scene: EXR with layers, PNG, report");
    add_render_options(*render, request.render);
    render->add_flag("--dry-run", request.render.dry_run, "check everything and print what would be done, as `explain` does; render nothing");
    add_animate_options(*app.add_subcommand("animate", "Renders a frame for every value of a <default> of the scene; goes on where it was stopped"), request.animate);
    auto* explain = app.add_subcommand("explain", "Says what `render` with the same options would simulate, what not and why, with memory and time");
    add_explain_options(*explain, request.explain);
    add_compare_options(*app.add_subcommand("compare", "Sets two images, or methods at equal time, side by side"), request.compare);
    add_merge_options(*app.add_subcommand("merge", "Makes one image of the shards of a render, byte-equal to one run"), request.merge);
    auto* info = app.add_subcommand("info", "Prints what was read from a scene");
    info->add_option("scene", request.info.scene, "scene file, Mitsuba 3 XML")->required()->type_name("SCENE.XML");
    info->add_flag("--json", request.info.json, "as JSON");
    add_load_options(*info, request.info.load);
    add_selftest_options(*app.add_subcommand("selftest", "Runs the hard cases on host and device; exit code 8 if one is outside its bounds"), request.selftest);
    add_bench_options(*app.add_subcommand("bench", "Measures how many pairs per second a device evaluates, at every lane width"), request.bench);
    add_devices_options(*app.add_subcommand("devices", "Lists the OpenCL devices"), request.devices);
    app.add_subcommand("man", "Prints this program's manual page, for man -l -");
    app.add_subcommand("completion", "Prints what makes a shell complete commands and options: source <(tyndall completion bash)")
        ->add_option("shell", request.shell, "bash, zsh or fish")->required()->type_name("SHELL");
    add_to_all(app, request);
}

std::vector<std::string> option_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const auto* option : app.get_options())
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> command_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const auto* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
    return names;
}

/// What stands behind CLI11's "not expected" or "required": the first argument that nobody knows, with the nearest name.
std::string unknown_argument(const CLI::App& app, int argc, char** argv)
{
    const CLI::App* command = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    for (int i = 1; i < argc; ++i) {
        const std::string argument(argv[i]);
        const auto stem = argument.substr(0, argument.find('='));
        if (stem.rfind("--", 0) == 0 && stem.size() > 2 && !command->get_option_no_throw(stem))
            return fmt::format("unknown option {}{}", stem, suggestion(stem, option_names(*command)));
        if (command == &app && stem[0] != '-')
            return fmt::format("unknown command \"{}\"{}", argument,
                               argument.ends_with(".xml") ? " (did you mean `tyndall render " + argument + "`?)"
                                                          : suggestion(argument, command_names(app)));
    }
    return {};
}

/// Help and version go to standard output and succeed; the rest is a usage error.
int end_of_parsing(const CLI::App& app, const CLI::ParseError& error, const std::vector<GivenValue>& given, int argc, char** argv)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    auto sentence = unknown_argument(app, argc, argv);
    if (sentence.empty()) sentence = error.what() + source_of_mistake(error.what(), given);
    throw UsageError(sentence + "\n`tyndall -h` and `tyndall render -h` list what there is");
}

/// Takes the variables away from all options, and returns them.
std::vector<std::pair<CLI::Option*, std::string>> without_variables(CLI::App& app)
{
    std::vector<std::pair<CLI::Option*, std::string>> variables;
    for (CLI::App* command : app.get_subcommands(nullptr))
        for (CLI::Option* option : command->get_options()) variables.emplace_back(option, option->get_envname()), option->envname("");
    return variables;
}

/// With the values that come from the environment and from a file, unless the command line makes no sense by itself.
std::vector<std::string> complete(const std::vector<std::string>& arguments, std::vector<GivenValue>& given)
{
    Request scratch;
    CLI::App app("", "tyndall");
    declare(app, scratch);
    const auto variables = without_variables(app);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::RequiredError&) {  // what is missing may be in the file
        if (app.get_subcommands().empty()) return arguments;
    } catch (const CLI::ParseError&) {
        return arguments;
    }
    for (const auto& [option, variable] : variables) option->envname(variable);
    const CLI::App& command = *app.get_subcommands().front();
    given = given_values(app, command);
    return with_values(arguments, command.get_name(), given);
}

/// The scene of a command that renders one.
std::optional<Scene> scene_of(const CLI::App& app, const Request& request)
{
    const bool animate = app.got_subcommand("animate");
    if (!animate && !app.got_subcommand("render") && !app.got_subcommand("explain")) return std::nullopt;
    const RenderCommand& command = animate ? request.animate.render : app.got_subcommand("render") ? request.render : request.explain.render;
    return load_scene(std::filesystem::is_directory(command.scene) ? command.scene / "scene.xml" : command.scene, command.load);
}

int print(const std::string& text)
{
    say("{}", text);
    return static_cast<int>(ExitCode::ok);
}

/// Parses what is complete. Nothing, or the exit code if that is all that there is to do.
std::optional<int> parse(CLI::App& app, const std::vector<std::string>& arguments, const std::vector<GivenValue>& given, int argc, char** argv)
try {
    if (!given.empty()) without_variables(app);
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return std::nullopt;
} catch (const CLI::ParseError& error) {
    return end_of_parsing(app, error, given, argc, argv);
} catch (const UsageError& error) {
    throw UsageError(error.what() + source_of_mistake(error.what(), given));
}

/// Will OpenCL be called?
bool uses_device(const CLI::App& app, const Request& request)
{
    if (app.got_subcommand("render")) return request.render.settings.method != Method::path;
    return !app.got_subcommand("info") && !app.got_subcommand("merge") && !app.got_subcommand("man") && !app.got_subcommand("completion");
}

int run(int argc, char** argv)
{
    Request request;
    CLI::App app("Tyndall renders fog, smoke and juice with virtual ray lights on any OpenCL device.", "tyndall");
    declare(app, request);
    std::vector<GivenValue> given;
    const auto arguments = complete({argv + 1, argv + argc}, given);
    if (const auto code = parse(app, arguments, given, argc, argv)) return *code;
    if (request.print_config) {
        const auto scene = scene_of(app, request);
        return print(config_listing(*app.get_subcommands().front(), given, scene ? &*scene : nullptr));
    }
    std::optional<KernelCache> cache;
    if (uses_device(app, request)) cache.emplace();
    std::string invocation = "tyndall";
    for (int i = 1; i < argc; ++i) invocation += " " + shell_quoted(argv[i]);
    request.compare.invocation = request.bench.invocation = invocation;
    if (app.got_subcommand("man")) return print(manual_page(app, version_number()));
    if (app.got_subcommand("completion")) return print(completion_script(app, request.shell));
    if (app.got_subcommand("render")) return run_render(request.render);
    if (app.got_subcommand("animate")) return run_animate(std::move(request.animate));
    if (app.got_subcommand("explain")) return run_explain(request.explain);
    if (app.got_subcommand("compare")) return run_compare(request.compare);
    if (app.got_subcommand("merge")) return run_merge(request.merge);
    if (app.got_subcommand("info")) return run_info(request.info);
    if (app.got_subcommand("selftest")) return run_selftest(request.selftest);
    if (app.got_subcommand("bench")) return run_bench(request.bench);
    return run_devices(request.devices);
}

/// Data that did not reach standard output is a failure too.
int flushed(int code)
{
    if (code == 0 && (std::fflush(stdout) != 0 || std::ferror(stdout)))
        throw IoError("standard output could not be written; the disk may be full, or what reads it has gone away");
    return code;
}

}  // namespace

int run_command_line(int argc, char** argv)
{
    hold_standard_streams();
    report_write_signals_as_errors();
    try {
        return flushed(run(argc, argv));
    } catch (...) {
        return report_failure();
    }
}

}  // namespace tyndall
