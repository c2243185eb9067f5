"""Which surfaces ship: name -> source and description."""

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
