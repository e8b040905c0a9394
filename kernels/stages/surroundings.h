// Where, in whose media, a stage works: what all of them take besides the eyes and the lights.
#ifndef SURROUNDINGS_H
#define SURROUNDINGS_H

typedef struct {
    __global const MediumRecord* media;
    __global const ContainerRecord* containers;
    __global const PlaneRecord* planes;
    uint container_count;
    __global const PhaseLobeRecord* lobes;
    __global const float* phase_values;
    __global const GridRecord* grids;
    __global const float* voxels;
} Surroundings;

/// As a kernel takes them, in the order of the host's PairStage, and puts them together.
#define SURROUNDINGS_PARAMETERS                                                                                                                \
    __global const MediumRecord *media, __global const ContainerRecord *containers, __global const PlaneRecord *planes, uint container_count, \
        __global const PhaseLobeRecord *lobes, __global const float *phase_values, __global const GridRecord *grids, __global const float *voxels
#define SURROUNDINGS {media, containers, planes, container_count, lobes, phase_values, grids, voxels}

#endif
