/// Sixteen shadow segments in the layout of Embree's RTCRay16, written by the device and answered by the host. Segment i goes from `from` to
/// from + 1 * (to - from): t is relative to the segment's length. tfar < tnear: nothing to ask; tfar = -infinity on return: blocked.
#ifndef SHADOW_PACKET_H
#define SHADOW_PACKET_H

#define SHADOW_PACKET_SIZE 16

typedef struct {
    float origin_x[SHADOW_PACKET_SIZE], origin_y[SHADOW_PACKET_SIZE], origin_z[SHADOW_PACKET_SIZE], tnear[SHADOW_PACKET_SIZE];
    float direction_x[SHADOW_PACKET_SIZE], direction_y[SHADOW_PACKET_SIZE], direction_z[SHADOW_PACKET_SIZE], time[SHADOW_PACKET_SIZE];
    float tfar[SHADOW_PACKET_SIZE];
    uint mask[SHADOW_PACKET_SIZE], id[SHADOW_PACKET_SIZE], flags[SHADOW_PACKET_SIZE];
} ShadowPacket;
LAYOUT(ShadowPacket, 768)

#endif
