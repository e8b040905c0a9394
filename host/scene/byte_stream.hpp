#pragma once
/// Binary files of numbers, texts and lists: one description of a type's fields writes and reads it.
///
/// A type is described by a function `fields(stream, value)` in its own namespace that calls `stream(member)` for each member in order; `value` is const for a
/// ByteWriter. Numbers are stored as they lie in memory, little-endian.
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "tyndall/error.hpp"

namespace tyndall {

static_assert(std::endian::native == std::endian::little, "files of numbers are stored little-endian");

/// 64 bits that change with every bit of the bytes: each word enters by a bijection of the state, so a change within one word is always seen, and others but for one in 2^64.
/// Not a defence against somebody who wants a collision.
class Checksum {
public:
    void add(std::span<const std::byte> bytes)
    {
        size_ += bytes.size();
        std::size_t i = 0;
        while (i < bytes.size() && filled_ != 0) add_byte(bytes[i++]);
        for (; i + 8 <= bytes.size(); i += 8) std::memcpy(&word_, bytes.data() + i, 8), close_word();
        while (i < bytes.size()) add_byte(bytes[i++]);
    }
    std::uint64_t value() const
    {
        Checksum last = *this;
        last.close_word(), last.word_ = size_, last.close_word();
        return last.state_;
    }

private:
    void add_byte(std::byte b)
    {
        word_ |= static_cast<std::uint64_t>(b) << (8 * filled_);
        if (++filled_ == 8) close_word();
    }
    void close_word()
    {
        state_ = (state_ ^ word_) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 29;
        word_ = 0, filled_ = 0;
    }
    std::uint64_t state_ = 0x243f6a8885a308d3u, word_ = 0, size_ = 0;
    int filled_ = 0;
};

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Numbers, or structures of numbers without gaps: vectors of them are stored as one piece.
template <class T>
inline constexpr bool stored_as_bytes = PlainNumber<T> && !std::is_same_v<T, bool>;

class ByteWriter {
public:
    using Sink = std::function<void(std::span<const std::byte>)>;
    explicit ByteWriter(Sink sink) : sink_(std::move(sink)) {}

    void raw(std::span<const std::byte> bytes) { sink_(bytes); }
    template <class T>
    void operator()(const T& value)
    {
        if constexpr (PlainNumber<T>) raw(std::as_bytes(std::span(&value, 1)));
        else fields(*this, value);
    }
    void operator()(const std::string& text) { (*this)(std::uint64_t(text.size())), raw(std::as_bytes(std::span(text))); }
    template <class T>
    void operator()(const std::vector<T>& list)
    {
        (*this)(std::uint64_t(list.size()));
        if constexpr (stored_as_bytes<T>) raw(std::as_bytes(std::span(list)));
        else
            for (const T& item : list) (*this)(item);
    }
    template <class T>
    void operator()(const std::optional<T>& maybe)
    {
        (*this)(maybe.has_value());
        if (maybe) (*this)(*maybe);
    }

private:
    Sink sink_;
};

/// Reads what a ByteWriter wrote. Throws SceneError where the bytes end too early or a count cannot be true; allocates nothing that the bytes left could not fill.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

    std::size_t left() const { return left_.size(); }
    std::span<const std::byte> raw(std::uint64_t size)
    {
        if (size > left_.size()) throw SceneError("its bytes end too early");
        const auto piece = left_.first(static_cast<std::size_t>(size));
        left_ = left_.subspan(piece.size());
        return piece;
    }
    template <class T>
    void operator()(T& value)
    {
        if constexpr (std::is_same_v<T, bool>) value = number<std::uint8_t>() != 0;
        else if constexpr (PlainNumber<T>) value = number<T>();
        else fields(*this, value);
    }
    void operator()(std::string& text)
    {
        const auto bytes = raw(number<std::uint64_t>());
        text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    template <class T>
    void operator()(std::vector<T>& list)
    {
        const auto count = number<std::uint64_t>();
        if (count > left_.size()) throw SceneError("a list in it is longer than the file");  // every item takes a byte at least
        if constexpr (stored_as_bytes<T>) {
            if (count > left_.size() / sizeof(T)) throw SceneError("a list in it is longer than the file");
            const auto bytes = raw(count * sizeof(T));
            list.resize(static_cast<std::size_t>(count));
            if (!bytes.empty()) std::memcpy(list.data(), bytes.data(), bytes.size());
        } else {
            list.clear();
            for (std::uint64_t i = 0; i < count; ++i) (*this)(list.emplace_back());
        }
    }
    template <class T>
    void operator()(std::optional<T>& maybe)
    {
        if (number<std::uint8_t>()) (*this)(maybe.emplace());
        else maybe.reset();
    }

private:
    template <class T>
    T number()
    {
        T value;
        std::memcpy(&value, raw(sizeof(T)).data(), sizeof(T));
        return value;
    }
    std::span<const std::byte> left_;
};

}  // namespace tyndall
