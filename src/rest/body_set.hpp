#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace flying {

/// Some of the bodies, to be walked through in order, or asked for one by one.
class BodySet
{
public:
    /// bodies  how many there are in all
    explicit BodySet(int bodies = 0) : has_(static_cast<std::size_t>(bodies), 0) {}

    [[nodiscard]] bool has(int body) const { return has_[body] != 0; }
    /// Ascending.
    [[nodiscard]] std::span<const int> list() const { return list_; }
    [[nodiscard]] bool empty() const { return list_.empty(); }

    void insert(std::span<const int> more)
    {
        const auto middle = static_cast<std::ptrdiff_t>(list_.size());
        for (const int body : more) {
            if (has(body)) continue;
            has_[body] = 1;
            list_.push_back(body);
        }
        std::sort(list_.begin() + middle, list_.end());
        const bool in_order = middle == 0 || middle == std::ssize(list_) || list_[middle - 1] < list_[middle];
        if (!in_order) std::inplace_merge(list_.begin(), list_.begin() + middle, list_.end());
    }
    void insert(int body) { insert(std::span(&body, 1)); }

    void erase(std::span<const int> gone)
    {
        if (std::none_of(gone.begin(), gone.end(), [&](int body) { return has(body); })) return;
        for (const int body : gone) has_[body] = 0;
        std::erase_if(list_, [&](int body) { return !has(body); });
    }

private:
    std::vector<char> has_;
    std::vector<int> list_;
};

} // namespace flying
