#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// Whether objects stand in the scene, or in the axes of a prototype that a list places.
enum class Where { scene, prototype };

Attribute material_name() {
  return required("material", NameType{}, "", "Name of one of the scenario's materials.");
}
Attribute on_terrain(const std::string& doc) {
  return defaulted("on_terrain", boolean(), "", "false", doc);
}

std::vector<Attribute> placement(Where where) {
  std::vector<Attribute> attributes = {
      defaulted("east_m", coordinate(), "m", "0", "Of the object's origin."),
      defaulted("north_m", coordinate(), "m", "0", "Of the object's origin."),
      defaulted("up_m", coordinate(), "m", "0", "Of the object's origin."),
      defaulted("yaw_deg", full_turn(), "deg", "0",
                "Clockwise about up, seen from above; turned first."),
      defaulted("pitch_deg", full_turn(), "deg", "0", "About the object's x axis; turned second."),
      defaulted("roll_deg", full_turn(), "deg", "0", "About the object's y axis; turned last."),
      defaulted("scale", VectorType{from_to(1e-4, 1e4), true}, "", "1",
                "Factor along the object's own axes, before it is turned.")};
  if (where == Where::scene) {
    attributes.push_back(on_terrain("up_m counts from the terrain below instead of the site."));
  }
  return attributes;
}

/// When something is in the scene; what a list places comes and goes with the list.
void add_presence_attributes(std::vector<Attribute>& attributes) {
  attributes.push_back(optional("present_from", InstantType{}, "", "from the beginning",
                                "When it comes; shadows that it cast stay in temperatures."));
  attributes.push_back(optional("present_until", InstantType{}, "", "for ever",
                                "When it leaves: at this moment it is not there any more."));
}

/// An object: its own attributes, then its name and where it stands.
ElementType object(Where where, const std::string& name, const std::string& doc,
                   std::vector<Attribute> own) {
  for (Attribute& attribute : own_temperature()) own.push_back(std::move(attribute));
  own.push_back(optional("name", NameType{}, "", "the element's name", "For reports."));
  for (Attribute& attribute : placement(where)) own.push_back(std::move(attribute));
  if (where == Where::scene) add_presence_attributes(own);
  const std::string id = where == Where::scene ? name : "prototype_" + name;
  const std::string place = where == Where::scene ? "" : " In the axes of what the list places.";
  return {.id = id, .name = name, .doc = doc + place, .attributes = std::move(own)};
}

std::vector<ElementType> objects(Where where) {
  const NumberType size = above_to(0.0, 1e7);
  ElementType mesh = object(
      where, "mesh",
      "Triangles from a file, in metres. Needs a material, a part, or both: parts that are not "
      "listed have the mesh's material.",
      {required("file", PathType{{".obj", ".ply"}}, "", "Wavefront OBJ or PLY."),
       optional("material", NameType{}, "", "every part must be listed",
                "Name of one of the scenario's materials.")});
  mesh.content = Content::list;
  mesh.children = {{"part"}};
  return {
      mesh,
      object(where, "sphere", "A ball around the object's origin.",
             {material_name(), required("radius_m", size, "m", "Radius.")}),
      object(where, "disc", "A flat disc around the object's origin.",
             {material_name(), required("radius_m", size, "m", "Radius."),
              defaulted("normal", VectorType{from_to(-1.0, 1.0), false}, "", "0 0 1",
                        "Direction of its upper side; any length but 0.")}),
      object(
          where, "box", "A box with sides along the object's axes.",
          {material_name(),
           required("lo_m", VectorType{coordinate(), false}, "m", "Corner of least x, y, z."),
           required("hi_m", VectorType{coordinate(), false}, "m", "Corner of greatest x, y, z.")}),
      object(
          where, "plane", "A level rectangle around the object's origin.",
          {material_name(), required("size_x_m", size, "m", "Along x (east, before it is turned)."),
           required("size_y_m", size, "m", "Along y (north, before it is turned).")}),
      object(
          where, "cylinder", "A tube from base to top.",
          {material_name(), required("radius_m", size, "m", "Radius."),
           defaulted("base_m", VectorType{coordinate(), false}, "m", "0 0 0", "Centre of one end."),
           required("top_m", VectorType{coordinate(), false}, "m", "Centre of the other end."),
           defaulted("capped", boolean(), "", "false", "Discs close both ends.")}),
  };
}

std::vector<Child> object_children(Where where) {
  std::vector<Child> children;
  for (const char* name : {"mesh", "sphere", "disc", "box", "plane", "cylinder", "instances"}) {
    children.push_back({(where == Where::scene ? "" : "prototype_") + std::string{name}});
  }
  return children;
}

ElementType instances(Where where) {
  std::vector<Attribute> attributes = {
      required("list", PathType{{".csv"}}, "", "A placement in every row; docs/formats.md."),
      optional("name", NameType{}, "", "the element's name", "For reports.")};
  if (where == Where::scene) {
    attributes.push_back(on_terrain("up in the list counts from the terrain below."));
    add_presence_attributes(attributes);
  }
  const bool outer = where == Where::scene;
  return {.id = outer ? "instances" : "prototype_instances",
          .name = "instances",
          .doc = outer ? "Objects that are stored once and placed by every row of a list."
                       : "A list within what another list places.",
          .attributes = std::move(attributes),
          .content = Content::list,
          .children = object_children(Where::prototype),
          .at_least = 1};
}

ElementType terrain_type() {
  ElementType type{
      .id = "terrain",
      .name = "terrain",
      .doc = "Ground from a raster of heights in any map projection.",
      .attributes = {
          required("raster", PathType{}, "", "Any raster of heights in m that GDAL reads."),
          material_name(),
          defaulted("height_offset_m", from_to(-1e4, 1e4), "m", "0",
                    "Added to every height: the raster's datum above the ellipsoid."),
          optional("name", NameType{}, "", "the element's name", "For reports.")}};
  for (Attribute& attribute : own_temperature()) type.attributes.push_back(std::move(attribute));
  return type;
}

ElementType part_type() {
  ElementType type{
      .id = "part",
      .name = "part",
      .doc = "A part of a mesh and what it is made of. Its temperature goes before the mesh's.",
      .attributes = {required("name", TextType{}, "", "As in the mesh's file (OBJ: usemtl)."),
                     material_name()}};
  for (Attribute& attribute : own_temperature()) type.attributes.push_back(std::move(attribute));
  return type;
}

}  // namespace

std::vector<Attribute> scene_placement() { return placement(Where::scene); }

std::vector<ElementType> schema_of_geometry() {
  std::vector<Child> top = {{"terrain"}};
  for (Child& child : object_children(Where::scene)) top.push_back(std::move(child));
  std::vector<ElementType> all = {{.id = "geometry",
                                   .name = "geometry",
                                   .doc = "What rays can meet. At most one terrain.",
                                   .content = Content::list,
                                   .children = std::move(top),
                                   .at_least = 1},
                                  terrain_type()};
  for (ElementType& type : objects(Where::scene)) all.push_back(std::move(type));
  all.push_back(part_type());
  all.push_back(instances(Where::scene));
  for (ElementType& type : objects(Where::prototype)) all.push_back(std::move(type));
  all.push_back(instances(Where::prototype));
  return all;
}

}  // namespace nadir::sim
