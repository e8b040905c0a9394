// Where, in whose media, a stage works: what all of them take besides the eyes and the lights.
#ifndef SURROUNDINGS_H
#define SURROUNDINGS_H

/// Choices that all eyes of a group share for one pair are made for groups of so many neighbours, so that they do not depend on the lane width.
#define EYE_GROUP 16u

typedef struct {
    __global const MediumRecord* media;
    __global const ContainerRecord* containers;
    __global const PlaneRecord* planes;
    uint container_count;
    __global const PhaseLobeRecord* lobes;
    __global const float* phase_values;
    __global const GridRecord* grids;
    __global const float* voxels;
    __global const float* eye_tables;    ///< what lies along the eye segments, in groups of EYE_GROUP; empty without HETEROGENEOUS
    __global const float* light_tables;  ///< along the lights (kernels/volumes/optical_table.h)
} Surroundings;

PURE PhaseTables phase_tables(Surroundings s)
{
    PhaseTables tables = {s.lobes, s.phase_values};
    return tables;
}

/// As a kernel takes them, in the order of the host's PairStage, and puts them together.
#define SURROUNDINGS_PARAMETERS                                                                                                                \
    __global const MediumRecord *media, __global const ContainerRecord *containers, __global const PlaneRecord *planes, uint container_count, \
        __global const PhaseLobeRecord *lobes, __global const float *phase_values, __global const GridRecord *grids, __global const float *voxels
#define TABLES_PARAMETERS __global const float *eye_tables, __global const float *light_tables
#define SURROUNDINGS {media, containers, planes, container_count, lobes, phase_values, grids, voxels, eye_tables, light_tables}
#define SURROUNDINGS_WITHOUT_TABLES {media, containers, planes, container_count, lobes, phase_values, grids, voxels, 0, 0}

#endif
