package org.phrenic.anatomy.virtual;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

/** Reads {@link VirtualThoraxParameters} from YAML. Unknown keys, missing keys and wrong counts are errors. */
public final class VirtualThoraxParametersReader {
    private static final String FOLDER = "/org/phrenic/data/thorax/";

    private final String source;

    private VirtualThoraxParametersReader(String source) {
        this.source = source;
    }

    /**
     * The measures that come with the program.
     *
     * @param preset {@code adult-male} or {@code adult-female}
     * @throws IllegalArgumentException if there is no such body
     */
    public static VirtualThoraxParameters preset(String preset) {
        String path = FOLDER + preset + ".yaml";
        try (InputStream in = VirtualThoraxParametersReader.class.getResourceAsStream(path)) {
            if (in == null) {
                throw new IllegalArgumentException(
                        "virtual thorax '" + preset + "' is not known, expected adult-male or adult-female");
            }
            return read(preset + ".yaml", new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Measures from a YAML text.
     *
     * @param source what to call the text in messages
     * @throws IllegalArgumentException with one sentence naming source and key if the text is no full set of measures
     */
    public static VirtualThoraxParameters read(String source, String text) {
        VirtualThoraxParametersReader reader = new VirtualThoraxParametersReader(source);
        try {
            return reader.thorax(reader.section(
                    "the document", YamlDocument.parse(source, text).toMap()));
        } catch (BadInputException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    private VirtualThoraxParameters thorax(Section root) {
        VirtualThoraxParameters parameters = new VirtualThoraxParameters(
                String.valueOf(root.take("name")),
                spine(root.section("spine")),
                wall(root.section("chest_wall")),
                ribs(root.section("ribs")),
                cartilages(root.section("cartilages")),
                sternum(root.section("sternum")),
                diaphragm(root.section("diaphragm")),
                lungs(root.section("lungs")),
                liver(root.section("liver")),
                skin(root.section("skin")));
        root.end();
        return parameters;
    }

    private static VirtualThoraxParameters.Spine spine(Section s) {
        int n = VirtualThoraxParameters.VERTEBRAE;
        var spine = new VirtualThoraxParameters.Spine(
                s.number("kyphosis_radius_mm"),
                s.number("kyphosis_apex_mm"),
                s.number("apex_y_mm"),
                s.number("lordosis_radius_mm"),
                s.numbers("body_height_mm", n),
                s.numbers("body_width_mm", n),
                s.numbers("body_depth_mm", n),
                s.numbers("disc_height_mm", n - 1),
                s.numbers("transverse_reach_mm", n),
                s.numbers("transverse_back_mm", n),
                s.numbers("spinous_length_mm", n),
                s.numbers("spinous_drop_deg", n));
        s.end();
        return spine;
    }

    private static VirtualThoraxParameters.ChestWall wall(Section s) {
        var wall = new VirtualThoraxParameters.ChestWall(
                s.number("axis_fraction"),
                s.number("exponent_front"),
                s.number("exponent_back"),
                s.number("left_breadth_factor"),
                s.rows("sections", 5));
        s.end();
        return wall;
    }

    private static VirtualThoraxParameters.Ribs ribs(Section s) {
        var ribs = new VirtualThoraxParameters.Ribs(
                s.numbers("arc_mm", 12),
                s.numbers("pump_deg", 12),
                s.numbers("bucket_deg", 12),
                s.number("left_arc_factor"),
                s.number("height_mm"),
                s.number("thickness_mm"));
        s.end();
        return ribs;
    }

    private static VirtualThoraxParameters.Cartilages cartilages(Section s) {
        var cartilages = new VirtualThoraxParameters.Cartilages(
                s.numbers("join_fraction", 3), s.number("height_mm"), s.number("thickness_mm"));
        s.end();
        return cartilages;
    }

    private static VirtualThoraxParameters.Sternum sternum(Section s) {
        var sternum = new VirtualThoraxParameters.Sternum(
                s.number("manubrium_mm"),
                s.number("body_mm"),
                s.number("xiphoid_mm"),
                s.number("angle_deg"),
                s.number("body_lean_deg"),
                s.number("joint_y_mm"),
                (int) s.number("joint_level"),
                s.number("thickness_mm"),
                s.numbers("notch_fraction", 7));
        s.end();
        return sternum;
    }

    private static VirtualThoraxParameters.Diaphragm diaphragm(Section s) {
        var diaphragm = new VirtualThoraxParameters.Diaphragm(
                s.numbers("right_dome_mm", 3),
                s.numbers("left_dome_mm", 3),
                s.numbers("heart_plateau_mm", 3),
                s.number("dome_radius_x_mm"),
                s.number("dome_radius_y_mm"),
                s.number("heart_radius_x_mm"),
                s.number("heart_radius_y_mm"),
                s.number("blend_mm"),
                s.number("turn_radius_mm"),
                s.number("midline_turn_radius_mm"),
                s.number("gap_mm"),
                s.number("muscle_mm"),
                s.number("tendon_mm"),
                s.number("tendon_area_cm2"),
                s.rows("rim", 2));
        s.end();
        return diaphragm;
    }

    private static VirtualThoraxParameters.Lungs lungs(Section s) {
        var lungs = new VirtualThoraxParameters.Lungs(
                s.number("wall_inset_mm"),
                s.number("diaphragm_gap_mm"),
                s.numbers("apex_right_mm", 3),
                s.numbers("apex_left_mm", 3),
                s.number("apex_radius_mm"),
                s.numbers("base_right_mm", 2),
                s.numbers("base_left_mm", 2),
                s.numbers("mediastinum_mm", 2),
                s.numbers("heart_mm", 2),
                s.numbers("heart_centre_mm", 2),
                s.numbers("heart_radii_mm", 2),
                s.numbers("heart_front_share", 2));
        s.end();
        return lungs;
    }

    private static VirtualThoraxParameters.Liver liver(Section s) {
        var liver = new VirtualThoraxParameters.Liver(
                s.number("volume_ml"),
                s.number("diaphragm_gap_mm"),
                s.numbers("visceral_slope", 2),
                s.numbers("back_cut", 2),
                s.number("left_end_x_mm"));
        s.end();
        return liver;
    }

    private static VirtualThoraxParameters.Skin skin(Section s) {
        var skin = new VirtualThoraxParameters.Skin(s.number("exponent"), s.rows("sections", 4));
        s.end();
        return skin;
    }

    private Section section(String key, Object value) {
        if (!(value instanceof Map<?, ?> map)) {
            throw bad(key, value, "keys with values");
        }
        return new Section(key, map);
    }

    private IllegalArgumentException bad(String key, Object found, String expected) {
        return new IllegalArgumentException(source + ": " + key + " is " + found + ", expected " + expected);
    }

    /** One level of keys, each to be taken once. */
    private final class Section {
        private final String path;
        private final Map<?, ?> map;
        private final Set<Object> taken = new LinkedHashSet<>();

        Section(String path, Map<?, ?> map) {
            this.path = path;
            this.map = map;
        }

        Object take(String key) {
            if (!map.containsKey(key)) {
                throw new IllegalArgumentException(source + ": " + path + " lacks the key " + key);
            }
            taken.add(key);
            return map.get(key);
        }

        Section section(String key) {
            return VirtualThoraxParametersReader.this.section(key, take(key));
        }

        double number(String key) {
            return number(key, take(key));
        }

        private double number(String key, Object value) {
            if (!(value instanceof Number number) || !Double.isFinite(number.doubleValue())) {
                throw bad(path + "." + key, value, "a number");
            }
            return number.doubleValue();
        }

        ImmutableDoubleArray numbers(String key, int count) {
            return numbers(key, take(key), count);
        }

        private ImmutableDoubleArray numbers(String key, Object value, int count) {
            if (!(value instanceof List<?> list) || list.size() != count) {
                throw bad(path + "." + key, value, "a list of " + count + " numbers");
            }
            return ImmutableDoubleArray.of(
                    list.stream().mapToDouble(item -> number(key, item)).toArray());
        }

        List<ImmutableDoubleArray> rows(String key, int columns) {
            if (!(take(key) instanceof List<?> list) || list.size() < 2) {
                throw bad(path + "." + key, map.get(key), "a list of at least two rows of " + columns + " numbers");
            }
            List<ImmutableDoubleArray> rows =
                    list.stream().map(row -> numbers(key, row, columns)).toList();
            for (int i = 1; i < rows.size(); i++) {
                if (!(rows.get(i).at(0) > rows.get(i - 1).at(0))) {
                    throw bad(path + "." + key, "row " + (i + 1), "rows with a rising first number");
                }
            }
            return rows;
        }

        void end() {
            for (Object key : map.keySet()) {
                if (!taken.contains(key)) {
                    throw new IllegalArgumentException(
                            source + ": " + path + " has the key " + key + ", which no measure is called");
                }
            }
        }
    }
}
