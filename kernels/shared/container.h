/// A convex polyhedron filled with a medium: the half-spaces normal . x <= offset of `plane_count` planes. Vacuum outside, nothing else inside.
#ifndef CONTAINER_H
#define CONTAINER_H

typedef struct {
    uint medium, first_plane, plane_count, padding;
} ContainerRecord;
LAYOUT(ContainerRecord, 16)

typedef struct {
    float normal_x, normal_y, normal_z;  ///< outward, unit
    float offset;
} PlaneRecord;
LAYOUT(PlaneRecord, 16)

#endif
