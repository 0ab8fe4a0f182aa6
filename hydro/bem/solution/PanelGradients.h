#pragma once
#include <map>
#include <vector>

#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// Gradients along the panels of a function that has one value a panel, by least squares through
/// the neighbours across its edges: second order on panels of any shape. Neighbours beyond a crease
/// of 60° do not count; across the centreline of a half hull a panel's mirror image does.
/// Immutable; keeps references to both meshes.
/// THEORY.md, chapter 5.
class PanelGradients {
 public:
  /// Another panel, or the mirror image of one.
  struct Neighbour {
    int panel;
    bool isImage;
    Vec3 away;  ///< from the panel's centroid to its own [m]
  };
  /// g = Σ column × (value of that neighbour − value of the panel), columns in the panel's plane
  /// [1/m].
  struct Gradient {
    std::vector<Neighbour> neighbours;
    Eigen::Matrix3Xd columns;
  };

  /// @param wet the mesh `mesh` was made from: its shared vertices say which panels are neighbours.
  PanelGradients(const SurfaceMesh& wet, const PanelMesh& mesh);

  const Gradient& of(int panel) const { return gradients_[static_cast<std::size_t>(panel)]; }
  /// Panels that share edge i of a panel, itself included.
  const std::vector<int>& sharing(int panel, int i) const { return facesOf_.at(edge(panel, i)); }
  /// Edge i of a panel of a half hull lies on y = 0.
  bool onCentreline(int panel, int i) const;
  /// Middle of edge i, between its two vertices.
  Vec3 middle(int panel, int i) const;

 private:
  const Face& face(int i) const { return wet_.faces[static_cast<std::size_t>(i)]; }
  const Panel& panel(int i) const { return mesh_.panels[static_cast<std::size_t>(i)]; }
  std::pair<int, int> edge(int panel, int i) const;
  void addAround(int at, int one, std::vector<Neighbour>& found) const;
  std::vector<Neighbour> neighboursOf(int panel) const;
  Gradient gradientOf(int panel) const;

  const SurfaceMesh& wet_;
  const PanelMesh& mesh_;
  double tolerance_;
  std::map<std::pair<int, int>, std::vector<int>> facesOf_;  // of each edge
  std::vector<Gradient> gradients_;                          // of each panel
};

}  // namespace cutwater
