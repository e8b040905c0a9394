#include "device/native_chain.hpp"

#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>

#include "device/pair_stage_state.hpp"

namespace tyndall {
namespace {

struct Work {
    TileWork work;
    std::size_t packets, contributions;  ///< in the tile
    bool running = false, done = false;
    std::exception_ptr fault{};
};

/// What native kernels are to do, by number. A driver that has lost its device may run one late, or never: it holds no pointer into this program, and finds nothing that was taken out of here.
class WorkList {
public:
    std::uint64_t put(Work work)
    {
        const std::lock_guard lock(guard_);
        works_.emplace(++last_, std::move(work));
        return last_;
    }

    void run(std::uint64_t number, void* packets, void* contributions)
    {
        Work* const work = begin(number);
        if (!work) return;
        try {
            work->work({{static_cast<ShadowPacket*>(packets), work->packets}, {static_cast<float*>(contributions), work->contributions}});
        } catch (...) {  // no exception passes through the driver
            work->fault = std::current_exception();
        }
        const std::lock_guard lock(guard_);
        work->running = false, work->done = true;
        ended_.notify_all();
    }

    /// Waits if it is running, and forgets it. Returns what it threw, or that the driver has not run it.
    std::exception_ptr take(std::uint64_t number)
    {
        std::unique_lock lock(guard_);
        const auto found = works_.find(number);
        ended_.wait(lock, [&] { return !found->second.running; });
        const Work work = std::move(found->second);
        works_.erase(found);
        return work.done ? work.fault : std::make_exception_ptr(cl::Error(CL_OUT_OF_RESOURCES, "clEnqueueNativeKernel, whose function did not run,"));
    }

private:
    Work* begin(std::uint64_t number)
    {
        const std::lock_guard lock(guard_);
        const auto found = works_.find(number);
        if (found == works_.end() || found->second.running || found->second.done) return nullptr;
        found->second.running = true;
        return &found->second;
    }

    std::mutex guard_;
    std::condition_variable ended_;
    std::map<std::uint64_t, Work> works_;
    std::uint64_t last_ = 0;
};

WorkList& work_list()
{
    static WorkList& list = *new WorkList;  // lives as long as any thread of a driver
    return list;
}

struct Arguments {
    std::uint64_t number;
    void *packets, *contributions;
};

void CL_CALLBACK run_work(void* memory)
{
    const Arguments& a = *static_cast<const Arguments*>(memory);
    work_list().run(a.number, a.packets, a.contributions);
}

}  // namespace

std::vector<cl::Event> NativeChain::begin()
{
    if (started_ != 1) return {};
    cl::Event before;
    device_.queue.enqueueMarkerWithWaitList(nullptr, &before);
    return {before};
}

void NativeChain::enqueue(TileWork work, const cl::Buffer& packets, std::size_t packet_count, const cl::Buffer& contributions, std::size_t contribution_count)
{
    tiles_.push_back({work_list().put({std::move(work), packet_count, contribution_count})});
    Arguments arguments{tiles_.back().number, nullptr, nullptr};
    const cl_mem buffers[] = {packets(), contributions()};
    const void* places[] = {&arguments.packets, &arguments.contributions};  // in the copy of the arguments that the driver makes, buffers' addresses come here
    const cl_int code = clEnqueueNativeKernel(queue()(), run_work, &arguments, sizeof arguments, 2, buffers, places, 0, nullptr, nullptr);
    if (code != CL_SUCCESS) throw cl::Error(code, "clEnqueueNativeKernel");
}

void NativeChain::end(const cl::Event& added)
{
    tiles_.back().added = added_ = added;
    ++started_;
}

void NativeChain::wait_until(std::size_t left)
{
    tiles_[tiles_.size() - left - 1].added.wait();
    while (tiles_.size() > left) {
        const std::exception_ptr fault = work_list().take(tiles_.front().number);
        tiles_.pop_front();
        if (fault) std::rethrow_exception(fault);
    }
}

void NativeChain::make_room()
{
    if (tiles_.size() >= most_on_way) wait_until(most_on_way / 2);
}

void NativeChain::finish()
{
    if (!tiles_.empty()) wait_until(0);
    started_ = 0, added_ = cl::Event();
}

void NativeChain::drain() noexcept
{
    for (const Tile& tile : tiles_) work_list().take(tile.number);
    if (!tiles_.empty())
        for (cl::CommandQueue* queue : {&device_.queue, &second_}) clFinish((*queue)());  // the device has said already what is wrong
    tiles_.clear();
    started_ = 0, added_ = cl::Event();
}

bool PairStage::runs_native_kernels() const { return state_->device.native_kernels; }

void PairStage::chain(const PairTile& tile, TileWork work)
{
    State& s = *state_;
    if (!s.chain) s.chain = on_device(s.device, "making a second queue", [&] { return std::make_unique<NativeChain>(s.device); });
    NativeChain& chain = *s.chain;
    on_device(s.device, "sampling and adding pairs", [&] {
        chain.make_room();
        TileSlot& slot = s.slots[static_cast<std::size_t>(chain.slot())];
        slot.tile = tile;
        s.harvest(false);
        s.launch_sample(slot, chain.queue(), chain.begin());
        chain.enqueue(std::move(work), slot.packets.get(), s.packet_count(tile), slot.contributions.get(), s.contribution_count(tile));
        chain.end(s.launch_accumulate(slot, chain.queue(), chain.additions()));
    });
}

void PairStage::end_chain()
{
    if (state_->chain) on_device(state_->device, "waiting for added pairs", [&] { state_->chain->finish(); });
}

void PairStage::drop_chain() noexcept
{
    if (state_->chain) state_->chain->drain();
}

}  // namespace tyndall
