#pragma once
/// Descriptions of scenes that are refused.
#include <gmock/gmock.h>

#include <ostream>
#include <string>

#include "tyndall/tyndall.hpp"

namespace tyndall::test {

struct DescriptionFault {
    std::string name;
    void (*make)(api::SceneDescription&);
    std::string message;
};
inline void PrintTo(const DescriptionFault& fault, std::ostream* out) { *out << fault.name; }

/// The description, which is right, is refused once the fault is made in it.
inline void expect_refused(api::SceneDescription scene, const DescriptionFault& fault)
{
    fault.make(scene);
    try {
        const api::Scene made(scene);
        FAIL() << "was accepted";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(fault.message));
    }
}

}  // namespace tyndall::test
