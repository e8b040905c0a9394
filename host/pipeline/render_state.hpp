#pragma once
/// A render in a file: to go on with after an interruption (checkpoint), or to be merged with others (shard). host/docs/farm.md describes the format.
#include <filesystem>
#include <string>
#include <vector>

#include "film/film.hpp"
#include "film/film_image.hpp"
#include "report/report.hpp"

namespace tyndall {

/// Something that the bytes of an image depend on, as text.
struct StateSetting {
    std::string name, value;
    friend bool operator==(const StateSetting&, const StateSetting&) = default;
};

/// Which part of a render: shard i of n, from 1; 0 of 0 is all of it.
struct ShardNumber {
    int number = 0, of = 0;
    bool whole() const { return of == 0; }
};

/// Passes from `first` up to, but without, `end`; end 0: nobody knows yet.
struct PassRange {
    int first = 0, end = 0;
};

struct RenderState {
    std::vector<StateSetting> settings;
    ShardNumber shard;
    PassRange range;
    int run_passes = 0;     ///< of all shards together; 0: not known
    bool finished = false;  ///< nothing is left to render
    FilmWindow window;
    LayerSet asked;         ///< layers that were asked for; those without light are written black
    Report report;          ///< counts and times of the passes so far
    std::vector<Film> films;  ///< one with all passes; of a shard, one for each block of passes, in order

    /// Passes that the films hold.
    int passes() const;
};

/// Passes of a shard: whole blocks, as even as whole blocks allow; none if there are more shards than blocks before it.
PassRange passes_of(const ShardNumber& shard, int run_passes, int block_passes);

/// Writes atomically (film/atomic_file.hpp). Throws IoError.
void write_state(const std::filesystem::path& file, const RenderState& state);

/// Throws SceneError for a file that is missing, no state file, of another format version, cut short or damaged; the message says which.
RenderState read_state(const std::filesystem::path& file);

/// Where the settings of two states differ, a sentence each: "lanes is 8 here and 16 in b.shard". Empty: nowhere.
std::vector<std::string> differences(const std::vector<StateSetting>& here, const std::vector<StateSetting>& there, const std::string& there_name);

}  // namespace tyndall
