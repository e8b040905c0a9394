#pragma once
#include "report/report.hpp"

namespace tyndall {

class ByteReader;
class ByteWriter;

/// All of a report as bytes, and back. `load_report` throws SceneError for bytes that hold none.
void save(ByteWriter& writer, const Report& report);
Report load_report(ByteReader& reader);

/// Adds the counts, times and cases of passes that were rendered before this report's, or elsewhere, with the same settings. What follows from the film, what was left
/// out (`savings`) and texts stay.
void add_counts(Report& report, const Report& other);

}  // namespace tyndall
