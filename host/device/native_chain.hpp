#pragma once
/// Tiles that go through the device without the host between their commands; only files below host/device include this.
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "device/device_state.hpp"
#include "device/pair_stage.hpp"

namespace tyndall {

/// Two queues take tiles in turns: each samples its tile, runs a function of the host over it (a native kernel) and adds it. Additions follow each other in the order of the tiles, whatever queue they are in.
class NativeChain {
public:
    /// Tiles on their way, between which a render can be stopped: two are at work, the others keep the device busy until the host has woken up.
    static constexpr std::size_t most_on_way = 6;

    explicit NativeChain(DeviceState& device) : device_(device), second_(another_queue(device)) {}
    ~NativeChain() { drain(); }
    NativeChain(const NativeChain&) = delete;
    NativeChain& operator=(const NativeChain&) = delete;

    /// Of the next tile, 0 or 1.
    int slot() const { return static_cast<int>(started_ % 2); }
    cl::CommandQueue& queue() { return slot() == 0 ? device_.queue : second_; }

    /// What the next tile's first command waits for: everything that stands in the device's own queue when the other one gets its first tile.
    std::vector<cl::Event> begin();
    /// Enqueues `work` over the tile that lies in the two buffers; sizes in elements.
    void enqueue(TileWork work, const cl::Buffer& packets, std::size_t packet_count, const cl::Buffer& contributions, std::size_t contribution_count);
    /// What an addition waits for: the one before.
    std::vector<cl::Event> additions() const { return added_() ? std::vector<cl::Event>{added_} : std::vector<cl::Event>{}; }
    /// The tile's last command is enqueued.
    void end(const cl::Event& added);

    /// Until no more than half of the tiles that may be on their way are, if as many as may be are. Throws what a tile's work threw.
    void make_room();
    /// Until all are added. Throws what a tile's work threw.
    void finish();
    /// The same after a fault: throws nothing. Afterwards no work of before is running or begins, whatever the driver says of its queues.
    void drain() noexcept;

private:
    struct Tile {
        std::uint64_t number;  ///< of its work
        cl::Event added{};
    };
    void wait_until(std::size_t left);

    DeviceState& device_;
    cl::CommandQueue second_;
    std::deque<Tile> tiles_;  ///< on their way
    std::uint64_t started_ = 0;
    cl::Event added_;  ///< of the last tile
};

}  // namespace tyndall
