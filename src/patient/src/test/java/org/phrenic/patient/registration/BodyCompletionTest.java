package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibEnds;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.MeshedSegment;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** The virtual adult female is the patient: of her a scan shows the lungs alone, and the rest is made of the male. */
class BodyCompletionTest {
    private static Thorax thorax(String preset) {
        return VirtualThorax.ofPreset(preset, Resolution.LOW);
    }

    private static PatientBody scanOf(Thorax patient, String cutAt) {
        List<PatientStructure> organs = new ArrayList<>();
        for (Structure lung : patient.structuresOf(StructureKind.LUNG)) {
            organs.add(scanned(lung, cutAt));
        }
        return new PatientBody("patient", organs, ExpectedStructures.missing(organs), List.of());
    }

    static PatientStructure scanned(Structure s, String cutAt) {
        MeshedSegment meshed =
                new MeshedSegment(s.mesh(), 0, 0, DistanceSummary.NONE, MeshQuality.of(s.mesh()), 0.2, 1, 0);
        return PatientStructure.ofScan(
                s, new PatientStructure.Scan(List.of(1), 1000, 1000, ends(s.mesh(), cutAt), meshed));
    }

    /** Ends of a scan at sides of the box of a surface. */
    private static List<CutPlane> ends(TriangleMesh mesh, String sides) {
        return sides.chars()
                .mapToObj(letter -> {
                    int axis = Math.max("LPS".indexOf(letter), "RAI".indexOf(letter));
                    int sign = "LPS".indexOf(letter) >= 0 ? 1 : -1;
                    double[] normal = new double[3];
                    normal[axis] = sign;
                    double offset = sign * mesh.bounds()[sign > 0 ? 3 + axis : axis];
                    return new CutPlane(String.valueOf((char) letter), normal[0], normal[1], normal[2], offset);
                })
                .toList();
    }

    @Test
    void ofTheLungsAloneABodyIsMadeWhoseDiaphragmLiesNearThePatients() {
        Thorax patient = thorax("adult-female");
        Thorax template = thorax("adult-male");
        PatientBody body = BodyCompletion.complete(scanOf(patient, ""), template);
        assertThat(body.canBreathe()).isTrue();
        assertThat(body.missing()).isEmpty();
        assertThat(body.structures()).hasSameSizeAs(template.structures());
        for (PatientStructure organ : body.structures()) {
            boolean lung = organ.structure().kind() == StructureKind.LUNG;
            assertThat(organ.source()).isEqualTo(lung ? PatientStructure.Source.SCAN : PatientStructure.Source.VIRTUAL);
            if (lung) {
                assertThat(organ.distanceToScan().orElseThrow().mean()).isLessThan(3);
            }
        }
        TriangleMesh built = diaphragm(body.thorax());
        MeshTopology topology = new MeshTopology(built);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        double off = SurfaceComparison.of(built, diaphragm(patient)).byArea().mean();
        double before = SurfaceComparison.of(diaphragm(template), diaphragm(patient))
                .byArea()
                .mean();
        assertThat(off).as("from %.1f mm as the template lies", before).isLessThan(0.5 * before);
    }

    /** The lower third of the right lung lies 30 mm below the rest, which a scan cuts off above. */
    @Test
    void aPieceThatLiesApartFromALungThatIsCutOffIsKept() {
        Thorax patient = thorax("adult-female");
        List<PatientStructure> lungs = new ArrayList<>();
        double[] volumes = new double[2];
        for (Structure lung : patient.structuresOf(StructureKind.LUNG)) {
            double[] bounds = lung.mesh().bounds();
            double at = bounds[2] + (bounds[5] - bounds[2]) / 3;
            if (lung.side() == Side.LEFT) {
                lungs.add(scanned(lung, "S"));
                continue;
            }
            for (int piece = 0; piece < 2; piece++) {
                double[] p = lung.mesh().positions().clone();
                for (int z = 2; z < p.length; z += 3) {
                    p[z] = piece == 0 ? Math.max(p[z], at + 30) : Math.min(p[z], at);
                }
                TriangleMesh mesh = lung.mesh().withPositions(p);
                volumes[piece] = MeshMeasure.signedVolume(mesh);
                lungs.add(scanned(
                        new Structure(piece == 0 ? "lung_R" : "lung_R_2", lung.kind(), lung.level(), lung.side(), mesh),
                        piece == 0 ? "S" : ""));
            }
        }
        PatientBody scan = new PatientBody("patient", lungs, ExpectedStructures.missing(lungs), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        TriangleMesh right = body.structure("lung_R").orElseThrow().structure().mesh();
        assertThat(body.structure("lung_R_2")).isEmpty();
        assertThat(MeshMeasure.signedVolume(right)).isGreaterThan(0.95 * (volumes[0] + volumes[1]));
        assertThat(ConnectedComponents.of(right)).hasSize(2);
    }

    private static PatientBody stretched(Thorax patient, double across, double deep, double tall) {
        double[] factor = {across, deep, tall};
        List<PatientStructure> organs = new ArrayList<>();
        for (StructureKind kind : List.of(StructureKind.LUNG, StructureKind.RIB, StructureKind.VERTEBRA)) {
            for (Structure s : patient.structuresOf(kind)) {
                double[] p = s.mesh().positions().clone();
                for (int i = 0; i < p.length; i++) {
                    p[i] *= factor[i % 3];
                }
                organs.add(scanned(s.withMesh(s.mesh().withPositions(p)), ""));
            }
        }
        return new PatientBody("patient", organs, ExpectedStructures.missing(organs), List.of());
    }

    /** The woman is 0.9 times as large as the man. Voxels of 3 mm that a file states as 1 mm give a third of her. */
    @Test
    void aBodyOfNoPersonsSizeIsRefused() {
        Thorax patient = thorax("adult-female");
        Thorax template = thorax("adult-male");
        assertThatThrownBy(() -> BodyCompletion.complete(stretched(patient, 0.333, 0.333, 0.333), template))
                .isInstanceOf(BadInputException.class)
                .hasMessageMatching("found a body 0\\.3\\d\\d times as large as adult-male, expected 0.5 to 1.7 times;"
                        + " is the spacing right\\? see --spacing");
        assertThatThrownBy(() -> BodyCompletion.complete(stretched(patient, 1, 1, 2), template))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("times as tall as adult-male, expected more even proportions");
        assertThat(BodyCompletion.complete(stretched(patient, 0.8, 1.25, 1), template)
                        .canBreathe())
                .isTrue();
        assertThat(BodyCompletion.complete(stretched(patient, 1, 1, 0.6), template)
                        .notes())
                .anyMatch(note -> note.contains("expected more even proportions"));
    }

    private static TriangleMesh diaphragm(Thorax thorax) {
        return thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
    }

    @Test
    void anAbdominalScanIsCompletedUpwardFromItsBones() {
        Thorax patient = thorax("adult-female");
        double top = patient.find("vertebra_T08").orElseThrow().mesh().bounds()[5];
        List<PatientStructure> seen = new ArrayList<>();
        for (Structure s : patient.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if (bone && s.mesh().bounds()[5] <= top) {
                seen.add(scanned(s, ""));
            }
        }
        PatientBody scan = new PatientBody("patient", seen, ExpectedStructures.missing(seen), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        assertThat(body.canBreathe()).isTrue();
        // Ribs 7 and 8 are next to bones of the scan; T1 is 180 mm above the highest of them.
        assertThat(headError(body, patient, "rib_07_R")).isLessThan(4);
        assertThat(headError(body, patient, "rib_01_L")).isLessThan(20);
    }

    /** Of a sternum that is 40 mm shorter than the woman's the scan shows the lower half, with ribs 5 to 12. */
    @Test
    void theSternumEndsWhereTheScanShowsItsLowerEnd() {
        Thorax patient = thorax("adult-female");
        TriangleMesh sternum = PatientBody.merged(patient.structuresOf(StructureKind.STERNUM).stream())
                .orElseThrow();
        double low = sternum.bounds()[2] + 40;
        double middle = 0.5 * (sternum.bounds()[2] + sternum.bounds()[5]);
        int[] t = sternum.triangles();
        int[] part = IntStream.range(0, sternum.triangleCount())
                .filter(i -> IntStream.range(3 * i, 3 * i + 3)
                        .allMatch(c -> sternum.z(t[c]) > low && sternum.z(t[c]) < middle))
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3).map(c -> t[c]))
                .toArray();
        TriangleMesh piece = MeshRepair.repair(new TriangleMesh(sternum.positions(), part), 0, 0)
                .mesh();
        List<PatientStructure> seen = new ArrayList<>();
        seen.add(scanned(new Structure("sternum", StructureKind.STERNUM, 0, Side.MIDLINE, piece), "S"));
        for (Structure s : patient.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if (bone && s.level() >= 5) {
                seen.add(scanned(s, ""));
            }
        }
        PatientBody scan = new PatientBody("patient", seen, ExpectedStructures.missing(seen), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        double end = PatientBody.merged(body.thorax().structuresOf(StructureKind.STERNUM).stream())
                .orElseThrow()
                .bounds()[2];
        assertThat(end).isCloseTo(low, within(8.0));
    }

    /** The right side is scanned, and of the left lung a piece of 0.6 % of its volume before the heart. */
    @Test
    void aPieceOfALungDoesNotSayWhereTheLungLies() {
        Thorax patient = thorax("adult-female");
        List<PatientStructure> seen = new ArrayList<>();
        for (Structure s : patient.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if ((bone && s.side() != Side.LEFT) || (s.kind() == StructureKind.LUNG && s.side() == Side.RIGHT)) {
                seen.add(scanned(s, ""));
            }
        }
        Structure left = patient.find("lung_L").orElseThrow();
        double[] box = left.mesh().bounds();
        double[] p = left.mesh().positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] = box[0] + 0.1 * (p[i] - box[0]);
            p[i + 1] = box[1] + 0.25 * (p[i + 1] - box[1]);
            p[i + 2] = 0.45 * box[2] + 0.55 * box[5] + 0.25 * (p[i + 2] - box[2]);
        }
        seen.add(scanned(left.withMesh(left.mesh().withPositions(p)), "L"));
        // 1.1 mm without the piece; 5.2 mm where the lung is fitted to the piece.
        assertThat(lungError(seen, patient)).isLessThan(2);
    }

    /** An abdomen: the scan ends 25 mm above the liver, and shows ribs 7 to 12 and the lower ends of the lungs. */
    @Test
    void lungsThatTheScanCutsOffKeepTheirLowerEndsAndAreContinuedAbove() {
        Thorax patient = thorax("adult-female");
        double end = patient.find("liver").orElseThrow().mesh().bounds()[5] + 25;
        List<PatientStructure> seen = new ArrayList<>();
        for (Structure s : patient.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if ((bone && s.level() >= 7) || s.kind() == StructureKind.LIVER) {
                seen.add(scanned(s, ""));
            } else if (s.kind() == StructureKind.LUNG) {
                seen.add(scanned(lobe(s, s.name(), s.mesh().bounds()[2], end), "S"));
            }
        }
        PatientBody scan = new PatientBody("patient", seen, ExpectedStructures.missing(seen), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        assertThat(body.notInScan()).contains("part of the lungs").doesNotContain("lung_L", "lung_R", "liver");
        for (Side side : List.of(Side.LEFT, Side.RIGHT)) {
            Structure truth = patient.find(StructureKind.LUNG, 0, side).orElseThrow();
            PatientStructure lung = body.structure(truth.name()).orElseThrow();
            TriangleMesh mesh = lung.structure().mesh();
            assertThat(lung.source()).isEqualTo(PatientStructure.Source.EXTENDED);
            double[] below = IntStream.range(0, mesh.vertexCount())
                    .filter(v -> mesh.z(v) < end - 20)
                    .flatMap(v -> IntStream.range(3 * v, 3 * v + 3))
                    .mapToDouble(i -> mesh.positions()[i])
                    .toArray();
            assertThat(below).hasSizeGreaterThan(300);
            double[] off = new SurfaceDistance(truth.mesh()).unsignedDistance(below);
            assertThat(Arrays.stream(off).max().orElseThrow()).isCloseTo(0, within(1e-9));
            assertThat(MeshMeasure.signedVolume(mesh))
                    .isCloseTo(MeshMeasure.signedVolume(truth.mesh()), withinPercentage(12));
        }
    }

    /**
     * Every second rib and vertebra, and the right lung in two lobes, of which the scan's end cuts off the lower one.
     */
    @Test
    void aLungOfWhichOneLobeIsCutOffIsCompletedWhole() {
        Thorax patient = thorax("adult-female");
        List<PatientStructure> seen = new ArrayList<>();
        for (Structure s : patient.structures()) {
            boolean bone = s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA;
            if (bone && s.level() % 2 == 0) {
                seen.add(scanned(s, ""));
            }
        }
        Structure right = patient.find("lung_R").orElseThrow();
        double[] box = right.mesh().bounds();
        double fissure = 0.5 * (box[2] + box[5]);
        seen.add(scanned(lobe(right, "lung_R_upper", fissure, box[5]), ""));
        seen.add(scanned(lobe(right, "lung_R_lower", box[2] + 50, fissure), "I"));
        PatientBody scan = new PatientBody("patient", seen, ExpectedStructures.missing(seen), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        List<TriangleMesh> lungs = body.structures().stream()
                .map(PatientStructure::structure)
                .filter(s -> s.kind() == StructureKind.LUNG && s.side() == Side.RIGHT)
                .map(Structure::mesh)
                .toList();
        assertThat(lungs).hasSize(1);
        assertThat(MeshMeasure.signedVolume(lungs.get(0)))
                .isCloseTo(MeshMeasure.signedVolume(right.mesh()), withinPercentage(10));
    }

    static Structure lobe(Structure lung, String name, double low, double high) {
        double[] p = lung.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] = Math.max(low, Math.min(high, p[i]));
        }
        return new Structure(
                name, StructureKind.LUNG, 0, lung.side(), lung.mesh().withPositions(p));
    }

    /** Mean distance of the completed left lung from the patient's, mm. */
    private static double lungError(List<PatientStructure> seen, Thorax patient) {
        PatientBody scan = new PatientBody("patient", seen, ExpectedStructures.missing(seen), List.of());
        PatientBody body = BodyCompletion.complete(scan, thorax("adult-male"));
        return SurfaceComparison.of(
                        body.structure("lung_L").orElseThrow().structure().mesh(),
                        patient.find("lung_L").orElseThrow().mesh())
                .byArea()
                .mean();
    }

    private static double headError(PatientBody body, Thorax truth, String name) {
        Structure rib = body.structure(name).orElseThrow().structure();
        double[] head = RibEnds.find(rib.mesh(), rib.side()).head();
        return Vectors.distance(
                head,
                RibEnds.find(truth.find(name).orElseThrow().mesh(), rib.side()).head());
    }

    @Test
    void aBodyWithoutBoneLungAndLiverIsNotCompleted() {
        Structure skin = thorax("adult-female").structuresOf(StructureKind.SKIN).get(0);
        PatientBody bare = new PatientBody("patient", List.of(scanned(skin, "")), List.of("diaphragm"), List.of());
        PatientBody body = BodyCompletion.complete(bare, thorax("adult-male"));
        assertThat(body.structures()).isEqualTo(bare.structures());
        assertThat(body.notes()).singleElement().asString().contains("no bone, lung or liver");
    }
}
