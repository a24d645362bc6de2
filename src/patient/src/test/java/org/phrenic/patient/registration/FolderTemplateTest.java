package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * An abdomen of the virtual woman, which cuts her lungs and aorta off, is completed from another patient: the virtual
 * man with lobes, a lesion, a structure without a name and an aorta.
 */
class FolderTemplateTest {
    private static final Thorax WOMAN = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
    private static final String OF_EARLIER_IMPORT = "rib_12_R";
    private static final PatientBody SCAN = scan();
    private static final PatientBody BODY = BodyCompletion.complete(SCAN, template());

    private static Structure aorta(Thorax body) {
        return body.organs().get().stream()
                .filter(s -> s.name().equals("aorta"))
                .findFirst()
                .orElseThrow();
    }

    private static PatientBody scan() {
        double end = WOMAN.find("liver").orElseThrow().mesh().bounds()[5] + 25;
        List<PatientStructure> seen = new ArrayList<>();
        for (Structure s : WOMAN.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if (s.name().equals(OF_EARLIER_IMPORT)) {
                seen.add(new PatientStructure(s, PatientStructure.Source.VIRTUAL, Optional.empty(), Optional.empty()));
            } else if ((bone && s.level() >= 7) || s.kind() == StructureKind.LIVER) {
                seen.add(BodyCompletionTest.scanned(s, ""));
            } else if (s.kind() == StructureKind.LUNG) {
                seen.add(BodyCompletionTest.scanned(
                        BodyCompletionTest.lobe(s, s.name(), s.mesh().bounds()[2], end), "S"));
            }
        }
        seen.add(BodyCompletionTest.scanned(aorta(WOMAN), "S"));
        return new PatientBody("patient", seen, List.of(), List.of());
    }

    private static Thorax template() {
        Thorax man = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        List<Structure> all = new ArrayList<>();
        for (Structure s : man.structures()) {
            if (s.kind() == StructureKind.LUNG) {
                double[] box = s.mesh().bounds();
                double fissure = 0.5 * (box[2] + box[5]);
                all.add(BodyCompletionTest.lobe(s, s.name() + "_inferior", box[2], fissure));
                all.add(BodyCompletionTest.lobe(s, s.name() + "_superior", fissure, box[5]));
            } else {
                all.add(s);
            }
        }
        Structure aorta = aorta(man);
        all.add(aorta);
        all.add(new Structure("lesion_tumor", StructureKind.LESION, 0, Side.MIDLINE, aorta.mesh()));
        all.add(new Structure("other_5", StructureKind.OTHER, 0, Side.MIDLINE, aorta.mesh()));
        all.add(new Structure("trachea", StructureKind.OTHER, 0, Side.MIDLINE, aorta.mesh()));
        return new Thorax("other", all, List.of());
    }

    @Test
    void allLobesOfTheOtherPatientContinueALungThatTheScanCutsOff() {
        for (Side side : List.of(Side.LEFT, Side.RIGHT)) {
            Structure truth = WOMAN.find(StructureKind.LUNG, 0, side).orElseThrow();
            List<PatientStructure> lungs = BODY.structures().stream()
                    .filter(s -> s.structure().isSameAs(truth))
                    .toList();
            assertThat(lungs).singleElement().satisfies(lung -> {
                assertThat(lung.source()).isEqualTo(PatientStructure.Source.EXTENDED);
                assertThat(lung.structure().name()).isEqualTo(truth.name());
                assertThat(MeshMeasure.signedVolume(lung.structure().mesh()))
                        .isCloseTo(MeshMeasure.signedVolume(truth.mesh()), withinPercentage(15));
            });
        }
    }

    @Test
    void lesionsAndUnknownStructuresOfTheOtherPatientAreNotThePatients() {
        assertThat(BODY.structures())
                .extracting(s -> s.structure().name())
                .contains("trachea", "vertebra_T01")
                .doesNotContain("lesion_tumor", "other_5");
    }

    @Test
    void aVesselThatTheScanCutsOffStaysAsTheScanShowsIt() {
        PatientStructure aorta = BODY.structure("aorta").orElseThrow();
        assertThat(aorta.source()).isEqualTo(PatientStructure.Source.SCAN);
        assertThat(aorta.structure().mesh()).isSameAs(aorta(SCAN).structure().mesh());
    }

    private static PatientStructure aorta(PatientBody body) {
        return body.structure("aorta").orElseThrow();
    }

    @Test
    void aRibThatAnEarlierImportAddedIsInTheBodyOnce() {
        assertThat(BODY.structures().stream().filter(s -> s.structure().name().equals(OF_EARLIER_IMPORT)))
                .singleElement()
                .satisfies(rib -> assertThat(rib.source()).isEqualTo(PatientStructure.Source.VIRTUAL));
    }
}
