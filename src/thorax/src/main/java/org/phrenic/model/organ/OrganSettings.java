package org.phrenic.model.organ;

import org.phrenic.anatomy.Resolution;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;

/** Settings of the organs: which are present, their mesh resolution and their motion models. */
public final class OrganSettings {
    public static final ChoiceSetting<Resolution> RESOLUTION = Setting.named(
                    "resolution", "Resolution", Effect.ASSEMBLY)
            .describedAs("How finely to mesh: 12,047, 16,023 or 20,909 vertices, the sizes of Villard, Bourne and"
                    + " Bello 2009, table 1.")
            .choice(Resolution.MEDIUM);
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

    private OrganSettings() {}
}
