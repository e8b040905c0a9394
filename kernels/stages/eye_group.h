// What the connections of a group of LANES eyes have in common.
#ifndef EYE_GROUP_H
#define EYE_GROUP_H

typedef struct {
    uint number;             ///< of the group of LANES
    FacingPlanes facing;
    __global const LightChoice* choices;  ///< of the group of EYE_GROUP; unspecified without SELECTION
    // Density grids, unspecified without them:
    MediaOfGroup media;
    OpticalTable table;      ///< what lies along the eye segments
    real over_mass;          ///< of their tables
    uint key;                ///< of the first eye of the group of EYE_GROUP
    float depth;             ///< mean grey optical depth of the eye segments of the group of EYE_GROUP; 0 for points
} EyeGroup;

/// Mean of the optical depths of the EYE_GROUP eyes whose tables begin at `table`.
PURE float mean_depth(Surroundings s, __global const EyeRecord* eyes, __global const float* table)
{
    float sum = 0.0f;
    for (uint i = 0; i < EYE_GROUP; ++i) {
        MediumRecord m = s.media[MANY_MEDIA ? eyes[i].medium : 0u];
        __global const float* end = table + TABLE_INTERVALS * EYE_GROUP + i;
        float red = end[0], green = COLOURED_GRIDS ? end[TABLE_NODES * EYE_GROUP] : red, blue = COLOURED_GRIDS ? end[2u * TABLE_NODES * EYE_GROUP] : red;
        sum += m.sigma_t_r * red + m.sigma_t_g * green + m.sigma_t_b * blue;
    }
    return sum / (3.0f * (float)EYE_GROUP);
}

/// Which light a slot of the group's connections goes to, and what its contribution counts.
typedef struct {
    uint number;
    float weight;
} SlotLight;
PURE SlotLight light_in_slot(const EyeGroup* around, uint slot)
{
    SlotLight all = {slot, 1.0f};
    if (!SELECTION) return all;
    SlotLight chosen = {around->choices[slot].light, around->choices[slot].weight};
    return chosen;
}

/// `slots`: lights that every eye connects to.
PURE void find_group(EyeGroup* around, Surroundings s, Eye eye, __global const EyeRecord* eyes, uint group, __global const LightChoice* choices, uint slots)
{
    around->number = group;
    around->choices = choices + (SELECTION ? group * LANES / EYE_GROUP * slots : 0u);
    find_facing_planes(&around->facing, s, eye_position(eye));
    if (!HETEROGENEOUS) return;
    uint first = group * LANES / EYE_GROUP * EYE_GROUP;
    around->key = eyes[first].key, around->depth = 0.0f, around->over_mass = R(0.0);
    if (!EYES_HAVE_TABLES) return;
    around->media = media_of_group(eye.medium_index);
    around->table.first = s.eye_tables + (size_t)first * TABLE_FLOATS, around->table.stride = EYE_GROUP;
    around->table.lane = lane_index(0) + (group * LANES - first);
    around->table.per_length = intervals_per_length(eye_length(eye));
    around->over_mass = gather_lanes(around->table.first + (TABLE_FLOATS - 1u) * EYE_GROUP, around->table.lane);
    around->depth = mean_depth(s, eyes + first, around->table.first);
}

#endif
