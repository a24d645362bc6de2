package org.phrenic.model.organ;

import java.nio.file.Path;
import java.util.Locale;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.YamlMap;
import org.phrenic.file.Numbers;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;
import org.phrenic.parameter.SwitchSetting;

/** Settings of the organs: which are present, their mesh resolution and their motion models. */
public final class OrganSettings {
    public static final ChoiceSetting<Resolution> RESOLUTION = Setting.named(
                    "resolution", "Resolution", Effect.ASSEMBLY)
            .describedAs("How finely to mesh: 12,047, 16,023 or 20,909 vertices, the sizes of Villard, Bourne and"
                    + " Bello 2009, table 1.")
            .choice(Resolution.MEDIUM);
    /** Number of vertices that replaces that of the resolution; 0 if not given. */
    public static final Setting<Long> MESH_VERTICES = Setting.named("mesh_vertices", "Vertices", Effect.ASSEMBLY)
            .describedAs("How many vertices the deformable parts have, whatever the resolution.")
            .parsed(values -> 0L, OrganSettings::meshVertices, value -> value == 0 ? null : value);

    public static final ChoiceSetting<SternumModel> STERNUM = Setting.named("sternum", "Sternum", Effect.ASSEMBLY)
            .describedAs("springs: held to the ribs by springs. kinematic: a rigid fit to the ribs' ends. off:"
                    + " stands still.")
            .choice(SternumModel.SPRINGS);
    public static final ChoiceSetting<LungModel> LUNGS = Setting.named("lungs", "Lungs", Effect.ASSEMBLY)
            .describedAs("springs: a membrane held to diaphragm and chest wall. embedded: follow what is near."
                    + " off: none.")
            .choice(LungModel.SPRINGS);
    public static final SwitchSetting LIVER = Setting.named("liver", "Liver", Effect.ASSEMBLY)
            .describedAs("The liver moves along with the dome.")
            .onOff(true);

    private static final long MIN_MESH_VERTICES = 1_000;
    private static final long MAX_MESH_VERTICES = 1_000_000;

    private OrganSettings() {}

    private static long meshVertices(YamlMap yaml, String key, Path folder) {
        long value = yaml.integer(key);
        if (value < MIN_MESH_VERTICES || value > MAX_MESH_VERTICES) {
            throw yaml.bad(key, "found " + value + ", expected " + MIN_MESH_VERTICES + " to " + MAX_MESH_VERTICES);
        }
        return value;
    }

    /** Number of vertices of the deformable parts: the given one, or that of the resolution. */
    public static MeshBudget budget(SettingValues values) {
        long given = values.get(MESH_VERTICES);
        return given > 0 ? new MeshBudget((int) given) : values.get(RESOLUTION).budget();
    }

    /** How fine the meshes are, in words: "medium", or "3,000 vertices" where their number is given. */
    public static String meshLabel(SettingValues values) {
        long given = values.get(MESH_VERTICES);
        return given > 0
                ? Numbers.format("%,d vertices", given)
                : values.get(RESOLUTION).name().toLowerCase(Locale.ROOT);
    }
}
