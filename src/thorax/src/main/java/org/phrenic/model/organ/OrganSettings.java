package org.phrenic.model.organ;

import org.phrenic.anatomy.Resolution;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.SwitchSetting;

/** Settings of the organs: which are present, their mesh resolution and their motion models. */
public final class OrganSettings {
    public static final ChoiceSetting<Resolution> RESOLUTION = ChoiceSetting.of(
            "resolution",
            "Resolution",
            Effect.ASSEMBLY,
            Resolution.MEDIUM,
            "How finely to mesh: 12,047, 16,023 or 20,909 vertices, the sizes of Villard, Bourne and Bello 2009,"
                    + " table 1.");
    public static final ChoiceSetting<SternumModel> STERNUM = ChoiceSetting.of(
            "sternum",
            "Sternum",
            Effect.ASSEMBLY,
            SternumModel.SPRINGS,
            "springs: held to the ribs by springs. kinematic: a rigid fit to the ribs' ends. off: stands still.");
    public static final ChoiceSetting<LungModel> LUNGS = ChoiceSetting.of(
            "lungs",
            "Lungs",
            Effect.ASSEMBLY,
            LungModel.SPRINGS,
            "springs: a membrane held to diaphragm and chest wall. embedded: follow what is near. off: none.");
    public static final SwitchSetting LIVER =
            new SwitchSetting("liver", "Liver", Effect.ASSEMBLY, true, "The liver moves along with the dome.");
    public static final ChoiceSetting<TendonRule> TENDON = ChoiceSetting.of(
            "tendon",
            "Tendon",
            Effect.ASSEMBLY,
            TendonRule.TREFOIL,
            "Central tendon: trefoil, or all above a plane as in Villard, Bourne and Bello 2009.");

    private OrganSettings() {}
}
