// SPDX-License-Identifier: Apache-2.0
// The picture that tells grids of voxels: a surface from outside, and planes of voxels coloured by value, with what of
// the surface lies behind them. Knows arrays of numbers only, no library of grids.
//
//     const Picture::VoxelSlice slices[] = {{.corner = c, .step_u = u, .step_v = v, .n_u = 80, .n_v = 60,
//                                            .values = numbers, .caption = "density"}};
//     Picture::WritePng("grid.png", Picture::GridPicture({.positions = p, .triangles = t}, slices));
#pragma once

#include <array>
#include <span>
#include <string>

#include <solidsubdiv/kit/picture/panels.h>
#include <solidsubdiv/kit/picture/scene.h>

namespace SolidSubdiv::Picture {

/// A plane of voxels, each a coloured square.
struct VoxelSlice {
    std::array<double, 3> corner{};            ///< centre of the first voxel
    std::array<double, 3> step_u{}, step_v{};  ///< from a voxel's centre to the next one's
    int n_u = 0, n_v = 0;                      ///< voxels; more than 1000 a side are thinned out
    std::span<const double> values{};          ///< (n_u, n_v), v fastest; NaN: the voxel is left out
    ColorMap map = ColorMap::Sequential;
    double low = 0, high = 0;  ///< values at the map's ends; equal: the least and greatest value
    std::string title{}, caption{};
};

struct GridPictureOptions {
    View view{.azimuth = 20, .elevation = 14};
    RenderOptions render{.width = 640, .height = 600};  ///< of one panel
    PanelOptions panels{};                              ///< columns 0: up to three
    std::string caption = "surface";                    ///< of the panel of the surface
};

/// A panel of the surface (if it has triangles), and one a slice, all with one camera.
/// @throws InvalidInput if there is neither surface nor slice, or numbers don't fit n_u x n_v
Image GridPicture(const Surface& surface, std::span<const VoxelSlice> slices, const GridPictureOptions& options = {},
                  const Progress& progress = {});

}  // namespace SolidSubdiv::Picture
