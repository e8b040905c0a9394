#include "lights/light_technique.hpp"

#include <string>

#include "tyndall/error.hpp"

namespace tyndall {

const LightTechnique* technique_of(Method method)
{
    if (method == Method::path) return nullptr;
    std::string known;
    for (const LightTechnique& technique : light_techniques()) {
        if (technique.method == method.name() || (!technique.clamped_method.empty() && technique.clamped_method == method.name())) return &technique;
        known += std::string(technique.method) + ", ";
        if (!technique.clamped_method.empty()) known += std::string(technique.clamped_method) + ", ";
    }
    throw UsageError("unknown method \"" + std::string(method.name()) + "\"; there are: " + known + "path");
}

bool is_clamped(Method method)
{
    const LightTechnique* technique = technique_of(method);
    return technique && technique->method != method.name();
}

bool is_thick(Method method)
{
    const LightTechnique* technique = technique_of(method);
    return technique && technique->is_thick;
}

std::vector<Method> all_methods()
{
    std::vector<Method> methods{Method::vrl};
    for (const LightTechnique& technique : light_techniques()) {
        if (technique.method != Method::vrl.name()) methods.push_back(Method(technique.method));
        if (!technique.clamped_method.empty()) methods.push_back(Method(technique.clamped_method));
    }
    methods.push_back(Method::path);
    return methods;
}

}  // namespace tyndall
