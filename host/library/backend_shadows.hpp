#pragma once
/// Shadow segments of tiles as questions to the caller.
#include "library/backend_records.hpp"
#include "tiling/connect_pairs.hpp"

namespace tyndall {

/// What connect_pairs asks; `media`: of each eye of the batch. All references must outlive it. Throws UsageError for a transmittance that is not finite or negative.
ShadowAnswer answer_by(const api::BackendDescription& caller, const BackendSpace& space, const std::vector<int>& media, const ConnectSettings& settings);

}  // namespace tyndall
