#pragma once
/// What a person sees while a render runs.
#include <cstdio>
#include <string>

#include "pipeline/render.hpp"

namespace tyndall {

enum class ProgressStyle {
    none,
    bar,    ///< one line on a terminal, written over after every pass
    plain,  ///< a line per 10 % or 30 s, whichever comes first; no carriage return, no colour
    json,   ///< one JSON object per pass and line
};

class ProgressView {
public:
    /// Writes to `stream`; `columns` is the terminal's width, for the bar.
    ProgressView(ProgressStyle style, std::FILE* stream, int columns = 80) : style_(style), stream_(stream), columns_(columns) {}
    /// Ends the bar's line, so that what follows starts on its own.
    ~ProgressView();
    ProgressView(const ProgressView&) = delete;
    ProgressView& operator=(const ProgressView&) = delete;

    void show(const Progress& progress);
    /// Ends the bar's line, if one is open.
    void end_line();

private:
    void show_bar(const Progress& progress);
    void show_plain(const Progress& progress);
    void show_json(const Progress& progress);

    ProgressStyle style_;
    std::FILE* stream_;
    int columns_;
    bool line_open_ = false;
    int tenths_shown_ = -1;
    double seconds_shown_ = 0;
};

/// Share of the budget that is used, in [0, 1]: of the passes or of the time, whichever is nearer to its end.
double share_done(const Progress& progress);

/// "pass 3/16, 41.2 M pairs/s, 3.10 M shadow segments/s, error 1.24 %, 12.3 s left"
std::string progress_text(const Progress& progress);

}  // namespace tyndall
