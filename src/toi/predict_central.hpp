#pragma once

#include "toi/predict.hpp"

namespace flying {

/// `predict` for two bodies of which at least one flies round a centre; all the same holds.
[[nodiscard]] Prediction predict_central(const Shape& a, const Flyer& flyer_a, const Shape& b, const Flyer& flyer_b,
                                         double from, const PredictOptions& options);

} // namespace flying
