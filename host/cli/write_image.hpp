#pragma once
/// The end of a render and of a merge: files, table, list of what was written.
#include "cli/outputs.hpp"
#include "cli/progress_view.hpp"
#include "pipeline/render_state.hpp"

namespace tyndall {

/// Writes EXR, PNG and report of a state with one film. Returns the report, with the film's errors and its ledger. Throws IoError.
Report write_image(const OutputPaths& paths, const RenderState& state, const ImageWishes& wishes);

/// To standard error: the report as a table, without the warnings that were printed before.
void print_summary(Report report, const std::vector<std::string>& printed_warnings);

/// To standard output: the files, or with ProgressStyle::json an object that holds them.
void print_outputs(const std::string& stopped_by, const std::vector<std::string>& outputs, ProgressStyle style);

}  // namespace tyndall
