package org.phrenic.model.material;

import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.assembly.SlidingSheet;
import org.phrenic.model.assembly.SwitchedConstraint;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.RampedValue;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SwitchSetting;

/**
 * Contact between the sheet and the chest wall, along which the sheet slides, and the constraint that keeps its
 * thoracic face outside the abdominal face.
 */
public final class WallContact extends ScenePart {
    public static final SwitchSetting CONTACT = Setting.named("contact", "Contact", Effect.SCENE)
            .describedAs("The diaphragm slides on the chest wall and does not pass through it.")
            .onOff(true);

    public WallContact() {
        super(Stage.CONSTRAINTS);
    }

    @Override
    public void addTo(Scene scene) {
        scene.system().add(scene.diaphragm().orderedPairs(scene.layout(), scene.refreshS()));
        SlidingSheet sheet = scene.slidingSheet();
        int[] nodes = MassSpringBuilder.offset(sheet.vertices(), scene.diaphragm().firstNode);
        SlidingContact contact = new SlidingContact(scene.layout(), nodes, sheet.wall(), scene.refreshS());
        scene.system().add(contact);
        RampedValue on = scene.ramped(CONTACT);
        SwitchedConstraint switched = new SwitchedConstraint(on, contact, () -> {});
        switched.restart(scene.system());
        scene.switches(switched);
        scene.tuning().whileRamping(time -> contact.setMaxReturnSpeed(SlidingContact.MAX_RETURN_SPEED * on.at(time)));
    }
}
