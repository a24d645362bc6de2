package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.SharedThorax;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibEnds;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** Ribs of a body that is known, shortened at the spine. */
class RibNeckTest {
    private static final Thorax FEMALE = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
    private static final Thorax MALE = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    /** Ribs 3 to 8, between their vertebrae: a scan of the middle of the chest. */
    private static List<Structure> ribs(Thorax body) {
        return body.structuresOf(StructureKind.RIB).stream()
                .filter(s -> s.level() > 2 && s.level() < 9)
                .toList();
    }

    private static double[] head(Structure rib) {
        return RibEnds.find(rib.mesh(), rib.side()).head();
    }

    /** The rib without what lies within a distance of its head; open there. */
    private static Structure shortened(Structure rib, double mm) {
        double[] head = head(rib);
        TriangleMesh mesh = rib.mesh();
        IntList kept = new IntList();
        for (int i = 0; i < mesh.triangles().length; i += 3) {
            boolean far = true;
            for (int k = 0; k < 3; k++) {
                int v = mesh.triangles()[i + k];
                far &= Vectors.distance(head, new double[] {mesh.x(v), mesh.y(v), mesh.z(v)}) > mm;
            }
            for (int k = 0; k < 3 && far; k++) {
                kept.add(mesh.triangles()[i + k]);
            }
        }
        double[] p = new double[3 * kept.size()];
        int[] t = new int[kept.size()];
        for (int i = 0; i < t.length; i++) {
            System.arraycopy(mesh.positions(), 3 * kept.get(i), p, 3 * i, 3);
            t[i] = i;
        }
        return rib.withMesh(MeshRepair.weld(new TriangleMesh(p, t), 1e-9).mesh());
    }

    private static PatientBody completed(Thorax patient, double mm) {
        return completed(patient, rib -> mm > 0 ? shortened(rib, mm) : rib);
    }

    private static PatientBody completed(Thorax patient, UnaryOperator<Structure> seenAs) {
        List<PatientStructure> seen = new ArrayList<>();
        List<Structure> shown = new ArrayList<>();
        ribs(patient).forEach(rib -> shown.add(seenAs.apply(rib)));
        patient.structuresOf(StructureKind.VERTEBRA).stream()
                .filter(s -> s.level() > 1 && s.level() < 10)
                .forEach(shown::add);
        for (Structure s : shown) {
            seen.add(new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()));
        }
        return BodyCompletion.complete(new PatientBody("patient", seen, List.of(), List.of()), MALE);
    }

    /** Mean distance of the heads from those of the whole ribs, mm; every rib has to be extended. */
    private static double offHeads(Thorax patient, double shortMm, double greatestMm) {
        PatientBody body = completed(patient, shortMm);
        double sum = 0;
        List<Structure> ribs = ribs(patient);
        for (Structure rib : ribs) {
            PatientStructure found = body.structure(rib.name()).orElseThrow();
            assertThat(found.source()).as(rib.name()).isEqualTo(PatientStructure.Source.EXTENDED);
            double off = Vectors.distance(head(found.structure()), head(rib));
            assertThat(off).as(rib.name()).isLessThan(greatestMm);
            sum += off;
        }
        return sum / ribs.size();
    }

    @Test
    void ribsThatEndShortOfTheSpineGetTheirHeadsBack() {
        assertThat(offHeads(FEMALE, 20, 7)).isLessThan(4);
    }

    @Test
    void ribsOfTheScannedManGetTheirHeadsBack() {
        assertThat(offHeads(SharedThorax.male(), 20, 9)).isLessThan(4.5);
    }

    /** Of right rib 5 the scan lacks the head and the angle: no straight neck of 110 mm is grown onto it. */
    @Test
    void aRibThatLacksItsBackTakesTheTemplatesCourse() {
        PatientBody body = completed(FEMALE, rib -> rib.name().equals("rib_05_R") ? shortened(rib, 100) : rib);
        PatientStructure found = body.structure("rib_05_R").orElseThrow();
        assertThat(found.source()).isEqualTo(PatientStructure.Source.VIRTUAL);
        assertThat(body.notes())
                .contains("ribs that end more than 60 mm short of the spine, taken from adult-male: rib_05_R")
                .noneMatch(note -> note.contains("given neck and head"));
        Structure truth = FEMALE.find("rib_05_R").orElseThrow();
        assertThat(Vectors.distance(head(found.structure()), head(truth))).isLessThan(7);
        double[] off = new TriangleTree(truth.mesh())
                .distances(found.structure().mesh().positions());
        assertThat(Arrays.stream(off).max().orElseThrow()).as("off the rib, mm").isLessThan(8);
    }

    @Test
    void wholeRibsStayAsTheyAre() {
        PatientBody body = completed(FEMALE, 0);
        for (Structure rib : ribs(FEMALE)) {
            assertThat(body.structure(rib.name()).orElseThrow().structure().mesh())
                    .isSameAs(rib.mesh());
        }
    }

    @Test
    void bodyOfAVertebraGoesWithItsPlaceAndSize() {
        TriangleMesh vertebra = FEMALE.find("vertebra_T06").orElseThrow().mesh();
        VertebralBody body =
                VertebralBody.of(new TriangleTree(vertebra), new double[] {1, 0, 0}, new double[] {0, 0, 1});
        double[] q = vertebra.positions().clone();
        for (int i = 0; i < q.length; i += 3) {
            q[i] = 1.3 * q[i] + 40;
            q[i + 1] = 0.8 * q[i + 1] - 10;
        }
        VertebralBody other = VertebralBody.of(
                new TriangleTree(vertebra.withPositions(q)), new double[] {1, 0, 0}, new double[] {0, 0, 1});
        assertThat(body.centre()[0]).isCloseTo(0, within(0.5));
        assertThat(other.centre()[0]).isCloseTo(40, within(0.5));
        assertThat(other.centre()[1]).isCloseTo(0.8 * body.centre()[1] - 10, within(1.0));
        assertThat(other.halfWidthMm()).isCloseTo(1.3 * body.halfWidthMm(), within(0.7));
        assertThat(other.halfDepthMm()).isCloseTo(0.8 * body.halfDepthMm(), within(0.7));
        assertThat(body.halfWidthMm()).isBetween(10.0, 16.0);
        assertThat(body.halfDepthMm()).isBetween(8.0, 14.0);
        assertThat(body.back()[1]).isEqualTo(1);
    }
}
