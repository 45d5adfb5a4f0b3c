#include "src/cage/table/scene_cage.hpp"

#include <fmt/format.h>
#include <cmath>

#include "src/cage/mesh/cage_mass.hpp"
#include "src/cage/table/cage_table_bytes.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

Material tabulated_material(const OperatingScene& scene) {
  Material material = cage_material(scene);
  if (!std::isnan(scene.cage.mass))
    material.density *= scene.cage.mass / cage_mass(scene.cage, scene.bearing.roller_count).mass;
  return material;
}

/// What a table of the scene's cage is made from.
struct TableInput {
  CageDimensions cage;
  Material material;
  CageStations stations;
  CageTableOptions options;
};

TableInput table_input(const OperatingScene& nominal, const GridPoint& point) {
  return {cage_dimensions(nominal),
          tabulated_material(nominal),
          cage_stations(nominal),
          {.density = nominal.cage.mesh_density, .point = point}};
}

/// Deviation of both surfaces from the tabulated ones as a share of the tabulated thickness.
double thickness_share(const CageDimensions& cage, const CageDimensions& tabulated) {
  return (std::abs(cage.outer_radius - tabulated.outer_radius) +
          std::abs(cage.inner_radius - tabulated.inner_radius)) /
         (tabulated.outer_radius - tabulated.inner_radius);
}

bool close(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

}  // namespace

GridPoint table_point(const OperatingScene& nominal, const OperatingScene& sample) {
  const CageDimensions cage = cage_dimensions(nominal);
  return nearest_point(cage, pocket_deviations(sample, cage));
}

std::string scene_cage_table_key(const OperatingScene& nominal, const GridPoint& point) {
  const TableInput in = table_input(nominal, point);
  return cage_table_key(in.cage, in.material, in.stations, in.options);
}

std::shared_ptr<const CageTable> make_scene_cage_table(const OperatingScene& nominal,
                                                       const GridPoint& point,
                                                       const TableProgress& progress) {
  const TableInput in = table_input(nominal, point);
  return std::make_shared<const CageTable>(
      make_cage_table(in.cage, in.material, in.stations, in.options, progress));
}

std::shared_ptr<const CageTable> scene_cage_table_from_bytes(const OperatingScene& nominal,
                                                             const GridPoint& point,
                                                             std::string_view bytes) {
  const TableInput in = table_input(nominal, point);
  CageTable table;
  if (!read_cage_table_bytes(bytes, table)) return nullptr;
  complete_cage_table(table, in.cage, in.material, in.stations, in.options);
  return std::make_shared<const CageTable>(std::move(table));
}

std::variant<std::shared_ptr<const CageModel>, CageFault> scene_cage_model(
    const OperatingScene& sample, const CageTable& table) {
  const CageDimensions cage = cage_dimensions(sample);
  const Material material = cage_material(sample);
  const bool same = cage.pocket_count == table.cage.pocket_count &&
                    close(cage.width, table.cage.width) &&
                    close(cage.corner_radius, table.cage.corner_radius) &&
                    close(material.young, table.material.young) &&
                    close(material.poisson, table.material.poisson);
  if (!same)
    return CageFault{
        CageFaultKind::outside_table, -1,
        "the cage differs from the tabulated one in more than its pockets: of a flexible "
        "cage only pockets and diameters may vary"};
  if (const double share = thickness_share(cage, table.cage); share > kThicknessShare + 1e-9)
    return CageFault{CageFaultKind::outside_table, -1,
                     fmt::format("bore and outside of the cage deviate together by {:.3g} % of the "
                                 "tabulated thickness, the cage table covers {:g} %",
                                 100 * share, 100 * kThicknessShare)};
  auto made = make_cage_model(table, pocket_deviations(sample, table.cage),
                              {.modes = sample.cage.modes, .bar_modes = sample.cage.bar_modes});
  if (auto* fault = std::get_if<CageFault>(&made)) return std::move(*fault);
  return std::make_shared<const CageModel>(std::move(std::get<CageModel>(made)));
}

}  // namespace cagetol
