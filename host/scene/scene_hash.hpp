#pragma once
/// 64 bits that tell scenes apart: FNV-1a over length-prefixed pieces, finished by a bijective mix so that every input bit reaches every
/// output bit. Not a defence against somebody who wants a collision.
#include <cstdint>
#include <string_view>

namespace tyndall {

class SceneHash {
public:
    void add(std::string_view bytes)
    {
        const std::uint64_t size = bytes.size();
        for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(size >> shift));
        for (const char c : bytes) add_byte(static_cast<unsigned char>(c));
    }
    std::uint64_t value() const
    {
        std::uint64_t x = state_;
        x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
        x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
        return x ^ (x >> 32);
    }

private:
    void add_byte(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3u; }
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace tyndall
