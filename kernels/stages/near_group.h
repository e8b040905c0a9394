// What the eyes of a group have in common when they take from lights that are near.
#ifndef NEAR_GROUP_H
#define NEAR_GROUP_H

/// Density grids; unspecified without them.
typedef struct {
    MediaOfGroup media;
    OpticalTable table;      ///< what lies along the eye segments
} NearGroup;

#endif
