package org.phrenic.model.material;

import java.util.List;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.SwitchedConstraint;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.TendonRule;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;
import org.phrenic.parameter.WholeSetting;

/** Rigid links across the central tendon: the tensegrity of Villard, Bourne and Bello 2009. */
public final class RigidTendon extends ScenePart {
    public static final ChoiceSetting<TendonRule> TENDON = Setting.named("tendon", "Tendon", Effect.ASSEMBLY)
            .describedAs("Central tendon: trefoil, or all above a plane as in Villard, Bourne and Bello 2009.")
            .choice(List.of(TendonRule.values()), ChoiceSetting::nameOf, values -> values.get(Materials.MATERIAL)
                    .tendonRule());
    public static final SwitchSetting TENSEGRITY = Setting.named("tensegrity", "Tensegrity", Effect.SCENE)
            .describedAs("Rigid links hold the two faces of the sheet apart.")
            .onOff(true);
    private static final int MAX_LINKS = 3;

    public static final WholeSetting LINKS_PER_NODE = Setting.named("links_per_node", "Links per node", Effect.ASSEMBLY)
            .describedAs("Rigid links a node of the sheet.")
            .whole(MAX_LINKS, values -> 1);

    private static final double TOLERANCE = 1e-6;
    private static final int SWEEPS = 50;

    public RigidTendon() {
        super(Stage.CONSTRAINTS);
    }

    @Override
    public void addTo(Scene scene) {
        DiaphragmPart diaphragm = scene.diaphragm();
        if (diaphragm.links.isEmpty()) {
            return;
        }
        int first = diaphragm.firstNode;
        int[] a = diaphragm.links.stream().mapToInt(p -> first + p.a()).toArray();
        int[] b = diaphragm.links.stream().mapToInt(p -> first + p.b()).toArray();
        RigidLinks links = RigidLinks.gaussSeidel(scene.layout(), a, b, scene.restPositions(), TOLERANCE, SWEEPS);
        scene.addLinks(links);
        RampedValue on = scene.ramped(TENSEGRITY);
        scene.switches(new SwitchedConstraint(on, links, () -> links.captureLengths(scene.system())));
        scene.tuning().whileRamping(time -> links.interpolateLengths(on.at(time)));
    }
}
