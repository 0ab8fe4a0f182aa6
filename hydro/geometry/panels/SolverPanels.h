#pragma once
#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// The panels on which the solver works: those of makePanels, or moved out to the curved surface on
/// which the mesh's vertices lie. A mesh inscribed in a round hull has less volume than the hull,
/// by (h/R)²/4 and more. With each panel moved along its normal by the mean height of the surface
/// over it, the volume is right to the next order.
///
/// The surface over a face is a paraboloid through its corners and those of its neighbours, by
/// least squares, across the centreline of a half hull too. Neighbours beyond a crease (30°) do not
/// count. Where the paraboloid does not fit (beside a knuckle, on a flat, with too few neighbours)
/// the panel stays. With PanelShape::Auto it also stays where the normals of the neighbours across
/// its edges are not the paraboloid's: where curvature changes within a panel, as it does in a
/// bilge of few panels. What tells is the greatest difference of a normal over the greatest turn
/// from the panel to a neighbour: up to 0.1 the panel is curved, from 0.2 on flat, partly between.
/// Turns above 0.25 rad count less, above 0.4 rad not at all. Where the neighbours
/// turn by no more than 0.01 rad, knuckles of 60° and more aside, the panel is part of a plane,
/// which is believed as a curved surface is; from 0.05 rad on it is not.
///
/// Edges on calm water stay on z = 0. The corners no longer meet those of the neighbours, and the
/// areas grow; what integrals of the normal need instead, the vector areas of the curved surface
/// and its bends, is in `patches`.
/// @param wet  hull below calm water, hull axes; its port half if `symmetric`.
/// @throws as makePanels.
PanelMesh solverPanels(const SurfaceMesh& wet, bool symmetric, PanelShape shape = PanelShape::Flat);

}  // namespace cutwater
