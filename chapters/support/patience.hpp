#pragma once

#include <stdexcept>
#include <string>

/// Counts the calls of a function that an answer may ask, and ends an answer that asks for ever.
class Patience
{
public:
    /// name  of the function
    /// most  calls that are waited for
    Patience(std::string name, int most) : name_(std::move(name)), most_(most) {}

    void count()
    {
        if (++calls_ > most_)
            throw std::runtime_error(name_ + " was asked " + std::to_string(most_) + " times, without an end");
    }
    [[nodiscard]] int calls() const { return calls_; }

private:
    std::string name_;
    int most_ = 0;
    int calls_ = 0;
};
