/// A box of voxels in render space; 64 bytes. Values are given at the centres of the voxels, trilinear between them, those of the outermost centres up to the
/// faces of the box, and 0 outside. Voxel coordinates: the box is [0, size_x] x [0, size_y] x [0, size_z], centres at whole numbers + 1/2.
#ifndef GRID_H
#define GRID_H

typedef struct {
    float x_x, x_y, x_z, x_0;  ///< voxel x = x_x p.x + x_y p.y + x_z p.z + x_0 of a point p of render space
    float y_x, y_y, y_z, y_0;
    float z_x, z_y, z_z, z_0;
    uint size_x, size_y, size_z;
    uint first;                ///< its voxels in the table of voxels: first + (z size_y + y) size_x + x; three channels: three such blocks, r, g, b
} GridRecord;
LAYOUT(GridRecord, 64)

#endif
