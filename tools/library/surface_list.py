"""Which surfaces ship: name -> source and description; and what lies beneath them."""

CANOPY = ("Reflectance of the whole canopy seen from above, shadows between and within crowns "
          "included: darker than single leaves. On modelled leaves and crowns it counts those "
          "shadows "
          "twice.")

# name: (class of visible to 2 um, class beyond or None for the same, description, notes)
NPOESS = {
    "compacted_soil": ("compacted_soil", None, "Compacted soil", []),
    "tilled_soil": ("tilled_soil", None, "Tilled soil, dark", []),
    "wet_soil": ("wet_soil", None, "Wet soil", []),
    "sand": ("sand", None, "Sand", []),
    "rock": ("rock", None, "Bare rock", []),
    "meadow_grass": (
        "meadow_grass", "irrigated_low_vegetation", "Meadow grass, green", [CANOPY,
        "Joined: the table's meadow grass is green below 2 um but has an emissivity of only 0.71 "
        "at "
        "5.5 um and 0.84 to 0.90 from 10 to 14 um, lower than any green vegetation "
        "(0.95 to 0.99); beyond 2 um the class of irrigated low vegetation is taken instead. "
        "meadow_grass_as_published keeps the original."]),
    "meadow_grass_as_published": (
        "meadow_grass", None, "Meadow grass as published by NPOESS, infrared doubtful", [CANOPY,
        "Emissivity 0.71 at 5.5 um and 0.84 to 0.90 from 10 to 14 um: lower than measured green "
        "vegetation. Kept for comparison."]),
    "irrigated_vegetation": ("irrigated_low_vegetation", None, "Irrigated low vegetation, dense",
                             [CANOPY]),
    "grass_on_soil": ("grass_soil", None, "Sparse grass on soil", [CANOPY,
        "A mixture with the table's meadow grass, whose emissivity from 10 to 14 um is doubtful: "
        "0.91 to 0.95 here."]),
    "scrub": ("scrub", None, "Scrub", [CANOPY]),
    "broadleaf_forest": ("broadleaf_forest", None, "Broadleaf forest canopy", [CANOPY]),
    "pine_forest": ("pine_forest", None, "Pine forest canopy", [CANOPY]),
    "mixed_forest": ("broadleaf70_pine30", None, "Mixed forest canopy, 70 % broadleaf, 30 % pine",
                     [CANOPY]),
    "tundra": ("tundra", None, "Tundra", [CANOPY]),
    "urban_concrete": ("urban_concrete", None, "Urban surface of mostly concrete, snow-free", [
        "Much darker (0.05 in the visible) than clean concrete: a mean over a town with its "
        "shadows."]),
}

METAL = ("As a Lambertian material it scatters diffusely; a polished plate would reflect like a "
         "mirror.")

# name: (file of the refractive index, description, notes)
FRESNEL = {
    "water": ("water_segelstein_1981", "Water surface, reflection at normal incidence", [
        "The light that water bodies scatter back from below the surface (their colour, mostly "
        "below "
        "0.7 um) is not modelled, nor the rise of reflectance at grazing angles."]),
    "ice_smooth": ("ice_warren_brandt_2008", "Clear ice surface, reflection at normal incidence", [
        "Light scattered back from inside (white ice, snow) is not modelled."]),
    "aluminium_polished": ("aluminium_rakic_1995", "Aluminium, polished", [METAL]),
    "copper_polished": ("copper_querry", "Copper, polished", [METAL]),
    "iron_polished": ("iron_querry", "Iron, polished", [METAL]),
    "gold_polished": ("gold_olmon_evap_2012", "Gold, polished (evaporated)", [METAL]),
}

ON_METAL = "Measured as a coat on aluminium, which shows through where the paint is translucent."
ON_WOOD = "Measured as two coats on pine."

# name: (part of the file name, description, notes)
MANMADE = {
    "asphalt_road": ("road_pavingasphalt_0095", "Road asphalt, weathered, some aggregate "
                                                "showing", []),
    "asphalt_black": ("road_pavingasphalt_0674", "Runway asphalt, black, little aggregate", []),
    "asphaltic_concrete": ("concrete_pavingconcrete_0425", "Asphaltic concrete, limestone "
                                                           "aggregate",
                           []),
    "tar_matte": ("road_tar_0099", "Construction tar, matte, weathered", []),
    "tar_glossy": ("road_tar_0100", "Construction tar, glossy", []),
    "concrete_light": ("concrete_pavingconcrete_0092",
                       "Concrete, grey-white, weathered runway", []),
    "concrete_weathered": ("constructionconcrete_0598",
                           "Concrete, 30 years old, granite aggregate showing", []),
    "concrete_bridge": ("concrete_pavingconcrete_0397", "Concrete of a bridge, smooth and "
                                                        "clean", []),
    "concrete_soiled": ("concrete_pavingconcrete_0424", "Concrete, grey, slightly soiled", []),
    "cinder_block": ("cementcinderblock_0432", "Cement cinder block, light brown", []),
    "cinders": ("cinder_0101", "Cinders, black, from a railroad bed", []),
    "brick_red": ("brick_0097", "Red brick, smooth-faced", []),
    "brick_weathered": ("brick_0412", "Red brick, weathered", []),
    "terracotta_tile": ("tile_0484", "Terracotta roof tile, weathered", []),
    "slate": ("shingle_0680", "Slate roof shingle, grey, weathered", []),
    "asphalt_shingle_grey": ("shingle_0597", "Asphalt roof shingle, grey granules, 15 years "
                                             "old", []),
    "asphalt_shingle_reddish": ("shingle_0683", "Asphalt roof shingle, reddish granules", []),
    "asphalt_shingle_reddish_old": ("shingle_0672", "Asphalt roof shingle, reddish, weathered", []),
    "asphalt_shingle_white": ("roofingshingle_0490",
                              "Asphalt roof shingle, white sand coating", []),
    "galvanised_steel": ("metal_0525uuustlb", "Galvanised steel roof, weathered", []),
    "galvanised_steel_dark": ("metal_0525uuustla", "Galvanised steel roof, weathered, dark film", [
        "The same sheet as galvanised_steel at another spot; its emissivity of 0.96 at 10 um is "
        "that of "
        "a coating or of dirt, not of bare metal."]),
    "galvanised_steel_oxidised": ("metal_0526uuustla", "Galvanised steel roof, fully oxidised", []),
    "aluminium_weathered": ("metal_0384", "Aluminium, bare, weathered and scratched", []),
    "copper": ("metal_0682", "Copper flashing, ten years old, bare", [
        "Reflectance of 0.98 from 8 to 12 um is high for a weathered sheet."]),
    "copper_patina": ("metal_0692", "Copper flashing, extremely weathered", []),
    "tar_paper": ("roofingpaper_0523", "Tar paper, black, new", []),
    "tar_paper_weathered": ("roofingpaper_0522", "Tar paper, black, cracked", []),
    "rubber_roof_white": ("rubber_0834",
                          "White rubber roof, glass-fibre reinforced, weathered", []),
    "rubber_roof_coating_white": ("rubber_0795", "White rubberised roof coating, five years "
                                                 "old", []),
    "rubber_roof_black": ("rubber_0833", "Black rubber roof, weathered", []),
    "paint_olive_on_metal": ("paint_0386", "Olive green gloss paint on aluminium, two coats",
                             [ON_METAL]),
    "paint_olive_on_wood": ("paint_0408", "Olive green paint on pine, two coats", [ON_WOOD]),
    "paint_black_on_metal": ("paint_0403", "Black gloss paint on aluminium, two coats", [ON_METAL]),
    "paint_black_on_wood": ("paint_0406", "Black paint on pine, two coats", [ON_WOOD]),
    "wood_weathered": ("wood_0404", "Pine wood, bare, weathered", []),
    "wood_sanded": ("wood_0410", "Pine wood, bare, sanded", []),
    "window_glass": ("glas_0796", "Window glass plate", [
        "Glass passes light below about 4.5 um. As an opaque material it absorbs what it does not "
        "reflect: right for a window of a dark room, wrong for a greenhouse."]),
    "marble_white": ("marble_0722", "White marble, weathered", []),
}


# What usually lies beneath each surface, for the heat balance. Each stack: layers from the surface
# inwards (substance of thermal.csv, thickness in m; None, of the last: as deep as the day's wave
# goes), attributes of <heat_balance> that differ from its defaults, and the reason in a line.
# Roughness as EnergyPlus' Engineering Reference gives it to walls: stucco very rough, brick rough,
# concrete medium rough, clear pine medium smooth, smooth plaster smooth, glass very smooth.

SOIL = ("soil_clay_moist", None)
INSIDE_K = 293.15  # heated or cooled
ROOM = {"back": "room", "room_temperature_k": INSIDE_K}
AIRY = {"back": "room"}  # an attic, a barn: its air has the outdoor temperature
OPEN = {"back": "open"}  # weather on both sides
DEEP_ICE_K = 273.15
# Wind over ground and water. TARP's films are those of plates 10 m long; over open ground some twice
# as much is measured. ASHRAE's law in the wind at 2 m (0.75 of that at 10 m, FAO 56 eq. 47) grows
# as FAO 56 says of lawns (5.9 against 5.8 W m-2 K-1 for each m/s), is within 15 % of Penman's wind
# function of water at 2 to 6 m/s, and gives roads what the Superpave rule does: docs/heat-year.md.
OUTDOORS = {"convection": "simple", "wind_factor": 0.75}


def ground(roughness: str) -> dict:
    return {**OUTDOORS, "roughness": roughness}


def grass(depth_m: float, wetness: float, reason: str) -> tuple:
    return ([("grass_canopy", depth_m), SOIL], {**ground("very_rough"), "wetness": wetness},
            reason)


def crowns(wetness: float, reason: str) -> tuple:
    return [("leaf_green", 0.0005)], {"roughness": "rough", "wetness": wetness, **OPEN}, reason


def road(asphalt_m: float, reason: str) -> tuple:
    return ([("asphalt_pavement", asphalt_m), ("soil_sandy_moist", 0.3), SOIL],
            ground("medium_rough"), reason)


def slab(concrete_m: float, reason: str) -> tuple:
    return [("concrete_dense", concrete_m), SOIL], ground("medium_rough"), reason


def brick_wall(reason: str) -> tuple:
    return ([("brick_red", 0.1), ("insulation_board", 0.05), ("gypsum_board", 0.013)],
            {"roughness": "rough", **ROOM}, reason)


def wooden_wall(cladding: str, thickness_m: float, reason: str) -> tuple:
    return ([(cladding, thickness_m), ("plywood", 0.0127), ("insulation_board", 0.09),
             ("gypsum_board", 0.013)], {"roughness": "medium_smooth", **ROOM}, reason)


def pitched_roof(cover: str, thickness_m: float, roughness: str, reason: str) -> tuple:
    return ([(cover, thickness_m), ("plywood", 0.0127)], {"roughness": roughness, **AIRY}, reason)


def flat_roof(cover: str, thickness_m: float, reason: str) -> tuple:
    return ([(cover, thickness_m), ("insulation_board", 0.1), ("steel_sheet", 0.0008)],
            {"roughness": "medium_rough", **ROOM}, reason)


def barn_roof(metal: str, reason: str) -> tuple:
    return [(metal, 0.0008)], {"roughness": "smooth", **AIRY}, reason


def sheet(metal: str, thickness_m: float, reason: str) -> tuple:
    return [(metal, thickness_m)], {"roughness": "smooth", **OPEN}, reason


LAWN = ("air over grass resists vapour by 104 s/m at 2 m/s, the leaves by 50 more by day and 200 "
        "by night (ASCE-EWRI 2005): shares of 0.7 and 0.3")
SHINGLES = "shingle on plywood, ventilated attic: its insulation lies on the attic's floor"
BARN = "bare sheet over a barn: the air inside follows that outside"
WALL = "common wall of a heated house"
PAINTED_METAL = "a car's body or a sign: sheet with air on both sides"
CROWN = "leaf with air on both sides: follows the air; a crown's wood and air are left out"

STACKS = {
    "compacted_soil": ([("soil_sandy_dry", 0.02), SOIL], ground("medium_rough"),
                       "a dry crust, through which hardly any vapour comes, on moist soil"),
    "tilled_soil": ([("soil_clay_dry", 0.05), SOIL],
                    {**ground("very_rough"), "wetness": 0.05},
                    "loose clods dry to a plough's first centimetres; some vapour from between"),
    "wet_soil": ([("soil_clay_saturated", None)], {**ground("rough"), "wetness": 0.9},
                 "saturated soil evaporates nearly as open water does, until it dries"),
    "sand": ([("soil_sandy_dry", None)], ground("medium_rough"),
             "dry as deep as the day's wave goes"),
    "rock": ([("stone", None)], ground("rough"), "outcrop of massive rock"),
    "meadow_grass": grass(0.10, 0.4, "as irrigated_vegetation, but short of water now and then"),
    "meadow_grass_as_published": grass(0.10, 0.4, "as meadow_grass: only the spectrum differs"),
    "irrigated_vegetation": grass(0.15, 0.5, "never short of water; " + LAWN),
    "grass_on_soil": grass(0.03, 0.25, "half of it bare: less vapour than a meadow gives"),
    "scrub": grass(0.20, 0.2, "dry places' leaves close their pores"),
    "broadleaf_forest": crowns(0.4, CROWN),
    "pine_forest": crowns(0.3, CROWN + "; needles give off less vapour"),
    "mixed_forest": crowns(0.4, CROWN),
    "tundra": ([("grass_canopy", 0.05), ("peat_saturated", None)],
               {**ground("rough"), "wetness": 0.5}, "thin growth on wet peat"),
    "urban_concrete": slab(0.15, "streets and yards; a town's roofs and walls differ"),
    # Albedo 0.07, a day's mean (Payne, J. Atmos. Sci. 29, 959, 1972): the spectrum is that of a sun
    # overhead and has nothing that comes back from below.
    "water": ([("water_mixed", 1.0)],
              {"solar_absorptance": 0.93, **ground("very_smooth"), "wetness": 1.0},
              "a pond 1 m deep, stirred by wind: nothing through its bed within a day"),
    "ice_smooth": ([("ice", 0.3)],
                   {**ground("very_smooth"), "wetness": 1.0, "back": "fixed",
                    "back_temperature_k": DEEP_ICE_K},
                   "a lake's ice on freezing water; not for summer: nothing melts"),
    "aluminium_polished": sheet("aluminium", 0.001, "plate with air on both sides"),
    "copper_polished": sheet("copper", 0.001, "plate with air on both sides"),
    "iron_polished": sheet("steel_carbon_painted", 0.003, "plate with air on both sides; optics "
                                                          "are the spectrum's, not paint's"),
    # gold_polished: a coat, whatever carries it: no default
    "asphalt_road": road(0.10, "wearing and base course on gravel, moist as roadbeds are"),
    "asphalt_black": road(0.15, "a runway's thicker asphalt on gravel"),
    "asphaltic_concrete": road(0.10, "as asphalt_road"),
    "tar_matte": flat_roof("built_up_roofing", 0.0095, "tar on an insulated flat roof"),
    "tar_glossy": flat_roof("built_up_roofing", 0.0095, "tar on an insulated flat roof"),
    "concrete_light": slab(0.30, "a runway's slab"),
    "concrete_weathered": slab(0.15, "a yard's or a foundation's slab"),
    "concrete_bridge": ([("concrete_dense", 0.25)],
                        {**OUTDOORS, "wind_factor": 1.0, "roughness": "medium_rough", **AIRY,
                         "room_film_w_m2_k": 15.0},
                        "a deck with moving air beneath: cools from both sides, freezes first"),
    "concrete_soiled": slab(0.15, "a pavement's slab"),
    "cinder_block": ([("concrete_lightweight", 0.2), ("gypsum_board", 0.013)],
                     {"roughness": "rough", **ROOM}, "uninsulated wall of a heated building"),
    "cinders": ([("soil_sandy_dry", 0.15), SOIL], ground("very_rough"),
                "a railroad's bed: loose grains with air between conduct as dry sand does"),
    "brick_red": brick_wall(WALL),
    "brick_weathered": brick_wall(WALL),
    "terracotta_tile": pitched_roof("slate_or_tile", 0.0127, "rough",
                                    "tiles on boards, ventilated attic"),
    "slate": pitched_roof("slate_or_tile", 0.008, "medium_rough",
                          "slates on boards, ventilated attic"),
    "asphalt_shingle_grey": pitched_roof("asphalt_shingle", 0.0064, "rough", SHINGLES),
    "asphalt_shingle_reddish": pitched_roof("asphalt_shingle", 0.0064, "rough", SHINGLES),
    "asphalt_shingle_reddish_old": pitched_roof("asphalt_shingle", 0.0064, "rough", SHINGLES),
    "asphalt_shingle_white": pitched_roof("asphalt_shingle", 0.0064, "rough", SHINGLES),
    "galvanised_steel": barn_roof("steel_sheet", BARN),
    "galvanised_steel_dark": barn_roof("steel_sheet", BARN),
    "galvanised_steel_oxidised": barn_roof("steel_sheet", BARN),
    "aluminium_weathered": barn_roof("aluminium", BARN),
    "copper": pitched_roof("copper", 0.0006, "smooth", "copper on boards, ventilated attic"),
    "copper_patina": pitched_roof("copper", 0.0006, "smooth", "copper on boards, ventilated attic"),
    "tar_paper": pitched_roof("built_up_roofing", 0.003, "medium_rough",
                              "paper on boards, ventilated attic or shed"),
    "tar_paper_weathered": pitched_roof("built_up_roofing", 0.003, "medium_rough",
                                        "paper on boards, ventilated attic or shed"),
    "rubber_roof_white": flat_roof("rubber_tyre", 0.0015, "rubber on insulation on a steel deck"),
    "rubber_roof_coating_white": flat_roof("rubber_tyre", 0.0015,
                                           "rubber on insulation on a steel deck"),
    "rubber_roof_black": flat_roof("rubber_tyre", 0.0015, "rubber on insulation on a steel deck"),
    "paint_olive_on_metal": sheet("steel_carbon_painted", 0.001, PAINTED_METAL),
    "paint_olive_on_wood": wooden_wall("wood_solid", 0.02, WALL + " of painted boards"),
    "paint_black_on_metal": sheet("steel_carbon_painted", 0.001, PAINTED_METAL),
    "paint_black_on_wood": wooden_wall("wood_solid", 0.02, WALL + " of painted boards"),
    "wood_weathered": wooden_wall("wood_siding", 0.0127, WALL + " with bare siding"),
    "wood_sanded": wooden_wall("wood_siding", 0.0127, WALL + " with bare siding"),
    "window_glass": ([("window_glass", 0.006)], {"roughness": "very_smooth", **ROOM},
                     "a single pane before a heated room; it is opaque here"),
    "marble_white": ([("stone", 0.03), ("concrete_heavyweight_ashrae", 0.2),
                      ("insulation_board", 0.05), ("gypsum_board", 0.013)],
                     {"roughness": "medium_smooth", **ROOM}, "a facade's facing"),
}
