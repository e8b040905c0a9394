#include "cli/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <map>

namespace tyndall {
namespace {

/// Text as roff prints it: no line is a request, no hyphen is a dash.
std::string roff(const std::string& text)
{
    std::string out;
    bool line_starts = true;
    for (const char c : text) {
        if (line_starts && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\') out += "\\e";
        else if (c == '-') out += "\\-";
        else out += c;
        line_starts = c == '\n';
    }
    return out;
}

/// "\fB-p\fR, \fB--passes\fR \fIN\fR".
std::string heading(const CLI::Option& option)
{
    std::string names;
    const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + fmt::format("\\fB{}\\fR", roff(name)); };
    for (const std::string& name : option.get_snames()) add("-" + name);
    for (const std::string& name : option.get_lnames()) add("--" + name);
    if (option.get_positional()) add(option.get_type_name());
    else if (option.get_expected_max() > 0) names += fmt::format(" \\fI{}\\fR", roff(option.get_type_name()));
    return names;
}

std::string command_section(const CLI::App& command)
{
    std::string text = fmt::format(".SS tyndall {}\n{}.\n", roff(command.get_name()), roff(command.get_description()));
    for (const CLI::Option* option : command.get_options()) text += fmt::format(".TP\n{}\n{}\n", heading(*option), roff(option->get_description()));
    return text;
}

/// Variables in place of options, with the options.
std::string environment(const CLI::App& app)
{
    std::map<std::string, std::string> options;
    for (const CLI::App* command : app.get_subcommands(nullptr))
        for (const CLI::Option* option : command->get_options())
            if (!option->get_envname().empty()) options.emplace(option->get_envname(), option->get_lnames().front());
    std::string text = ".SH ENVIRONMENT\nEvery option of \\fBrender\\fR, \\fBanimate\\fR and \\fBexplain\\fR has a variable, for example \\fBTYNDALL_TARGET_ERROR=1%\\fR in place of \\fB\\-\\-target\\-error 1%\\fR, "
                       "and \\fBTYNDALL_HALF=true\\fR for a flag. The command line wins over variables, variables over the file of \\fB\\-\\-config\\fR, the file over the scene. These stand in for options of other commands too:\n";
    for (const auto& [variable, option] : options) text += fmt::format(".TP\n\\fB{}\\fR\nin place of \\fB{}\\fR, which wins if both are given\n", roff(variable), roff("--" + option));
    return text + ".TP\n\\fBXDG_CACHE_HOME\\fR\nwhere it is remembered that a device has passed its check (\\fB.cache\\fR in the home folder)\n"
                  ".TP\n\\fBSOURCE_DATE_EPOCH\\fR\nif set, images hold nothing of the clock\n";
}

constexpr const char* exit_status = R"(.SH EXIT STATUS
.TP
\fB0\fR
done
.TP
\fB1\fR
internal error, or out of memory
.TP
\fB2\fR
the command line makes no sense
.TP
\fB3\fR
the scene, a file that it names, or an image to compare is invalid
.TP
\fB4\fR
no usable OpenCL device
.TP
\fB5\fR
a device, or its compiler, failed
.TP
\fB6\fR
the result could not be written
.TP
\fB7\fR
finished, but the target error was not reached in the passes or the time given
.TP
\fB8\fR
something is outside its bounds (selftest), or the error is above the tolerance (compare)
.TP
\fB75\fR
a temporary failure: another try may help
.TP
\fB129\fR, \fB130\fR, \fB143\fR
stopped by SIGHUP, SIGINT or SIGTERM: image and checkpoint of the passes so far were written
)";

}  // namespace

std::string manual_page(const CLI::App& app, const std::string& version)
{
    std::string text = fmt::format(".TH TYNDALL 1 \"\" \"tyndall {}\" \"User Commands\"\n.SH NAME\ntyndall \\- renders fog, smoke and juice\n.SH SYNOPSIS\n", roff(version));
    for (const CLI::App* command : app.get_subcommands(nullptr)) text += fmt::format(".B tyndall {}\n.I arguments\n.br\n", roff(command->get_name()));
    text += fmt::format(".SH DESCRIPTION\n{}\nScenes are Mitsuba 3 XML, images are layered OpenEXR. Standard output carries data only; what a person reads goes to standard error.\n.SH COMMANDS\n",
                        roff(app.get_description()));
    for (const CLI::App* command : app.get_subcommands(nullptr)) text += command_section(*command);
    return text + exit_status + environment(app);
}

}  // namespace tyndall
