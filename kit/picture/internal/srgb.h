// SPDX-License-Identifier: Apache-2.0
// The sRGB coding of light: IEC 61966-2-1, both ways.
#pragma once

#include <cmath>

namespace SolidSubdiv::Picture::Internal {

inline float EncodeSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}
inline float DecodeSrgb(float coded) {
    return coded <= 0.04045f ? coded / 12.92f : std::pow((coded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace SolidSubdiv::Picture::Internal
