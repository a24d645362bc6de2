package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

class ContactingOrgansTest {
    /** The sheet lies on the kidneys whether the scan labels each of them or both together. */
    @ParameterizedTest
    @ValueSource(strings = {"kidney_R", "Kidney_l", "kidney", "organ_kidneys"})
    void kidneysTouchTheDiaphragmUnderEveryNameThatTheyHave(String name) {
        Structure liver = VirtualThorax.ofPreset("adult-male", Resolution.LOW)
                .structuresOf(StructureKind.LIVER)
                .get(0);
        Structure kidney = new Structure(name, StructureKind.ORGAN, 0, Side.MIDLINE, liver.mesh());
        Structure cyst = new Structure("kidney_cyst_R", StructureKind.ORGAN, 0, Side.RIGHT, liver.mesh());
        Thorax body = new Thorax("abdomen", List.of(liver, kidney, cyst), List.of());
        assertThat(ContactingOrgans.abdominal(body)).containsExactly(liver, kidney);
    }
}
