#include "src/cage/scene_cage.hpp"

#include <cmath>

#include "src/cage/cage_mass.hpp"

namespace cagetol {
namespace {

Material tabulated_material(const Scene& scene) {
  Material material = scene.cage.material;
  if (!std::isnan(scene.cage.mass))
    material.density *= scene.cage.mass / cage_mass(scene.cage, scene.bearing.roller_count).mass;
  return material;
}

bool close(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

}  // namespace

GridPoint table_point(const Scene& nominal, const Scene& sample) {
  const CageDimensions cage = cage_dimensions(nominal.cage, nominal.bearing.roller_count);
  return nearest_point(cage, pocket_deviations(sample.cage, cage));
}

std::shared_ptr<const CageTable> make_scene_cage_table(const Scene& nominal, const GridPoint& point,
                                                       const std::filesystem::path& folder,
                                                       const CageTableNews& news) {
  const CageDimensions cage = cage_dimensions(nominal.cage, nominal.bearing.roller_count);
  const Material material = tabulated_material(nominal);
  const CageStations stations = cage_stations(nominal);
  const CageTableOptions options = {.density = nominal.cage.mesh_density, .point = point};
  return std::make_shared<const CageTable>(
      folder.empty() ? make_cage_table(cage, material, stations, options, news)
                     : cached_cage_table(folder, cage, material, stations, options, news));
}

std::variant<std::shared_ptr<const CageModel>, CageFault> scene_cage_model(const Scene& sample,
                                                                           const CageTable& table) {
  const CageDimensions cage = cage_dimensions(sample.cage, sample.bearing.roller_count);
  const bool same = cage.pocket_count == table.cage.pocket_count &&
                    close(cage.inner_radius, table.cage.inner_radius) &&
                    close(cage.outer_radius, table.cage.outer_radius) &&
                    close(cage.width, table.cage.width) &&
                    close(sample.cage.material.young, table.material.young) &&
                    close(sample.cage.material.poisson, table.material.poisson);
  if (!same)
    return CageFault{
        CageFaultKind::outside_table, -1,
        "the cage differs from the tabulated one in more than its pockets: of a flexible "
        "cage only pockets may vary"};
  auto made = make_cage_model(table, pocket_deviations(sample.cage, table.cage),
                              {.modes = sample.cage.modes, .stress = true});
  if (auto* fault = std::get_if<CageFault>(&made)) return std::move(*fault);
  return std::make_shared<const CageModel>(std::move(std::get<CageModel>(made)));
}

}  // namespace cagetol
