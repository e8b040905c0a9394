#include "cli/merge_command.hpp"

#include "cli/exit_code.hpp"
#include "cli/write_image.hpp"
#include "pipeline/merge_shards.hpp"

namespace tyndall {

int run_merge(const MergeCommand& command)
{
    const OutputPaths paths = plan_outputs(command.shards.front(), command.output, command.report);
    check_outputs(paths);
    const RenderState state = merge_shards(command.shards, command.mixed_devices);
    const Report report = write_image(paths, state, command.image);
    print_summary(report, {});
    print_outputs(report.stopped_by, report.outputs, ProgressStyle::plain);
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
