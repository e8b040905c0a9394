#pragma once
/// The files of a render: where they go and writing them.
#include <filesystem>
#include <optional>

#include "film/film_image.hpp"
#include "report/report.hpp"

namespace tyndall {

struct OutputPaths {
    std::filesystem::path exr, png, report;
};

/// The EXR is `output` (its name ends in .exr) or, if that is empty, the scene file's stem in the working folder; PNG and report (JSON)
/// have its name with another ending, unless `report` names the latter. Throws UsageError for another ending and for two files of one name.
OutputPaths plan_outputs(const std::filesystem::path& scene, const std::filesystem::path& output, const std::filesystem::path& report);

/// The shard file: `output` (its name ends in .shard) or, if that is empty, the scene file's stem with the shard's number, "fog.03-of-16.shard". Throws UsageError for another ending.
std::filesystem::path plan_shard(const std::filesystem::path& scene, const std::filesystem::path& output, int number, int of);

/// Makes the folder of several files, which -o names, and those around it. Throws IoError.
void make_folder(const std::filesystem::path& folder);

/// Throws IoError if one of them could not be written now, so that nothing is lost after an hour of rendering.
void check_outputs(const OutputPaths& paths);

struct ImageWishes {
    std::optional<double> exposure;  ///< stops; none: automatic
    bool half = false;
    bool timestamps = true;  ///< false: the EXR holds nothing that depends on the clock, so equal renders are byte-equal
};

/// Writes EXR, PNG and report, each whole or not at all; `asked`: layers that were asked for, of which those that the scene has no light for are written black. Fills in the report's exposure and outputs. Throws IoError.
void write_outputs(const OutputPaths& paths, const Film& film, const FilmWindow& window, const ImageWishes& wishes, const LayerSet& asked, Report& report);

}  // namespace tyndall
