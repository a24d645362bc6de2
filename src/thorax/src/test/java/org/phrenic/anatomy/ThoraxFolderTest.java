package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

class ThoraxFolderTest {
    /** Coordinates in files are single precision. */
    private static final double FILE_MM = 1e-4;

    @TempDir
    Path folder;

    private void write(List<Structure> structures) {
        for (Structure s : structures) {
            MeshFiles.write(folder.resolve(s.name() + ".ply"), s.mesh());
        }
    }

    private void refused(String... parts) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ThoraxFolder.load(folder))
                .satisfies(e -> assertThat(e.getMessage()).contains(parts));
    }

    @Test
    void filesAreKnownByTheirNamesAndComeInLpsMillimetres() {
        List<Structure> body = BoxBody.structures();
        write(BoxBody.given(body, "LSA", 10));
        Thorax thorax = ThoraxFolder.load(folder);
        assertThat(thorax.name()).isEqualTo(folder.getFileName().toString());
        assertThat(thorax.notes()).containsExactly("axes LSA, 10.0 mm a unit");
        assertThat(thorax.structures()).hasSameSizeAs(body);
        for (Structure s : body) {
            Structure loaded = thorax.find(s.name()).orElseThrow();
            assertThat(loaded.kind()).isEqualTo(s.kind());
            assertThat(loaded.level()).isEqualTo(s.level());
            assertThat(loaded.side()).isEqualTo(s.side());
            assertThat(loaded.mesh().positions()).containsExactly(s.mesh().positions(), within(FILE_MM));
        }
    }

    @Test
    void anIndexNamesTheBodyItsFrameAndWhichFileHoldsWhat() throws IOException {
        MeshFiles.write(folder.resolve("sheet.stl"), BoxBody.box(1, 2, 3, 1));
        MeshFiles.write(folder.resolve("costa.ply"), BoxBody.box(4, 5, 6, 1));
        MeshFiles.write(folder.resolve("rib_02_L.ply"), BoxBody.box(7, 8, 9, 1));
        Files.writeString(
                folder.resolve("thorax.yaml"),
                """
                name: someone
                axes: RAS
                units: cm
                structures:
                  diaphragm: sheet.stl
                  rib_05_R: costa.ply
                """);
        Thorax thorax = ThoraxFolder.load(folder);
        assertThat(thorax.name()).isEqualTo("someone");
        assertThat(thorax.structures()).extracting(Structure::name).containsExactly("diaphragm", "rib_05_R");
        double[] box = thorax.find("diaphragm").orElseThrow().mesh().bounds();
        // Centre (1, 2, 3) cm to the right, anterior and superior; an edge of 2 cm.
        assertThat(box).containsExactly(new double[] {-20, -30, 20, 0, -10, 40}, within(FILE_MM));
    }

    @Test
    void whatIsRepairedOrLeftOutIsSaid() {
        write(BoxBody.structures());
        TriangleMesh box = BoxBody.box(0, -90, 250, 10);
        int[] broken = java.util.Arrays.copyOf(box.triangles(), box.triangles().length + 3);
        broken[broken.length - 3] = 1;
        broken[broken.length - 2] = 1;
        broken[broken.length - 1] = 2;
        MeshFiles.write(folder.resolve("sternum_manubrium.ply"), new TriangleMesh(box.positions(), broken));
        MeshFiles.write(folder.resolve("blob.ply"), box);
        assertThat(ThoraxFolder.load(folder).notes())
                .anyMatch(n -> n.startsWith("sternum_manubrium: "))
                .anyMatch(n -> n.startsWith("blob.ply: left out"))
                .hasSize(3);
    }

    @Test
    void facesThatAreTurnedAreCounted() {
        write(BoxBody.structures());
        TriangleMesh box = BoxBody.box(0, -90, 250, 10);
        int[] inward = box.triangles().clone();
        for (int i = 0; i < inward.length; i += 3) {
            inward[i] = box.triangles()[i + 1];
            inward[i + 1] = box.triangles()[i];
        }
        MeshFiles.write(folder.resolve("sternum_manubrium.ply"), new TriangleMesh(box.positions(), inward));
        assertThat(ThoraxFolder.load(folder).notes())
                .contains("sternum_manubrium: Repaired: " + inward.length / 3 + " triangles flipped.");
    }

    @Test
    void axesThatDoNotFitTheBodyAreTakenButDoubted() throws IOException {
        write(BoxBody.given(BoxBody.structures(), "LSA", 1));
        Path index = folder.resolve("thorax.yaml");
        Files.writeString(index, "axes: LPS\n");
        assertThat(ThoraxFolder.load(folder).notes()).anyMatch(n -> n.contains("stated as LPS") && n.endsWith("LSA"));
        Files.writeString(index, "axes: LSA\n");
        assertThat(ThoraxFolder.load(folder).notes()).hasSize(1);
    }

    @Test
    void twoFilesForOneStructureAreRefused() {
        write(BoxBody.structures());
        MeshFiles.write(folder.resolve("rib_05_R.stl"), BoxBody.box(0, 0, 0, 1));
        refused("rib_05_R.ply", "rib_05_R.stl", "one file a structure");
    }

    @Test
    void twoSpellingsOfOneStructureAreRefused() {
        write(BoxBody.structures());
        MeshFiles.write(folder.resolve("rib_5_R.stl"), BoxBody.box(0, 0, 0, 1));
        refused("rib_05_R.ply", "rib_5_R.stl", "one file a structure");
    }

    /** Other code finds a structure by its name: the portal vein by its wall, the colon where a body is completed. */
    @Test
    void structuresAreNamedInTheUsualSpellingWhateverThatOfTheirFiles() throws IOException {
        write(BoxBody.structures());
        MeshFiles.write(folder.resolve("Portal_Vein.stl"), BoxBody.box(0, 0, 0, 1));
        MeshFiles.write(folder.resolve("Lung_r_MIDDLE.stl"), BoxBody.box(0, 0, 0, 1));
        Files.writeString(folder.resolve("thorax.yaml"), "not_in_scan: [Rib_5_r, The breath]");
        Thorax thorax = ThoraxFolder.load(folder);
        assertThat(thorax.structures())
                .extracting(Structure::name)
                .contains("portal_vein", "lung_R_middle", "rib_05_R")
                .doesNotContain("Portal_Vein");
        assertThat(thorax.isInScan(thorax.find("rib_05_R").orElseThrow())).isFalse();
        assertThat(thorax.notInScan()).contains("The breath");
    }

    @Test
    void twoFilesWhoseNamesDifferInCaseAloneAreRefused() {
        write(BoxBody.structures());
        MeshFiles.write(folder.resolve("Heart.stl"), BoxBody.box(0, 0, 0, 1));
        MeshFiles.write(folder.resolve("heart.ply"), BoxBody.box(0, 0, 0, 1));
        refused("Heart.stl", "heart.ply", "one file a structure");
    }

    /** What a folder of meshes is, is told by the names of its meshes, not by what else lies there. */
    @Test
    void aFolderWithTheMeshOfADiaphragmIsAWholeBody() throws IOException {
        Files.writeString(folder.resolve("notes-on-diaphragm.txt"), "none");
        Files.writeString(folder.resolve("._diaphragm.stl"), "macOS");
        MeshFiles.write(folder.resolve("liver.stl"), BoxBody.box(0, 0, 0, 1));
        assertThat(ThoraxFolder.isWhole(folder)).isFalse();
        MeshFiles.write(folder.resolve("Diaphragm.stl"), BoxBody.box(0, 0, 0, 1));
        assertThat(ThoraxFolder.isWhole(folder)).isTrue();
    }

    @Test
    void aBodyWithoutADiaphragmIsRefused() {
        write(BoxBody.structures().stream()
                .filter(s -> s.kind() != StructureKind.DIAPHRAGM)
                .toList());
        refused(folder.toString(), "no diaphragm among 37", "diaphragm.ply");
    }

    @Test
    void missingFolderAndMissingFileAreNamed() throws IOException {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ThoraxFolder.load(folder.resolve("nowhere")))
                .withMessageContaining("nowhere")
                .withMessageContaining("no such folder");
        Files.writeString(folder.resolve("thorax.yaml"), "structures:\n  diaphragm: gone.ply\n");
        refused("line 2", "diaphragm", "gone.ply");
    }

    @Test
    void theIndexIsCheckedKeyByKey() throws IOException {
        write(BoxBody.structures());
        Path index = folder.resolve("thorax.yaml");
        Files.writeString(index, "unit: mm\n");
        refused("line 1", "'unit'", "units");
        Files.writeString(index, "units: inch\n");
        refused("units", "'inch'", "mm, cm or m");
        Files.writeString(index, "axes: RPS\nunits: mm\n");
        refused("RPS", "mirrored");
        Files.writeString(index, "structures:\n  hart: diaphragm.ply\n");
        refused("hart", "rib_05_R or diaphragm");
    }

    private Thorax part() {
        return ThoraxFolder.loadPart(folder, Optional::of);
    }

    private void partRefused(String... parts) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(this::part)
                .satisfies(e -> assertThat(e.getMessage()).contains(parts));
    }

    /** Exchanged sides would agree with RAS, in which the body would lie with its back to the front. */
    @Test
    void aPartWhoseSidesAreExchangedIsRefused() {
        write(BoxBody.structures().stream()
                .filter(s -> s.kind() != StructureKind.DIAPHRAGM)
                .map(BoxBody::mirrored)
                .toList());
        partRefused(folder.toString(), "'RPS'", "mirrored", "left and right are exchanged");
    }

    /** A piece of a vertebra of 4 mm is no part of a trunk in mm, cm or m, but where the unit is stated. */
    @Test
    void aPartWithAStatedUnitNeedsNoneReadOffItsExtent() throws IOException {
        write(List.of(BoxBody.structures().get(2).withMesh(BoxBody.box(0, 90, 280, 2))));
        partRefused("units", "expected 80 to 1200 mm");
        Files.writeString(folder.resolve("thorax.yaml"), "units: mm\n");
        assertThat(part().notes()).containsExactly("axes LPS, 1.0 mm a unit");
    }

    @Test
    void aPartWithStatedAxesNeedsNoneReadOffItsNames() throws IOException {
        List<Structure> ribs = BoxBody.structures().stream()
                .filter(s -> s.kind() == StructureKind.RIB)
                .toList();
        write(BoxBody.given(ribs, "LSA", 10));
        partRefused("axes", "agree with neither LPS nor RAS");
        Files.writeString(folder.resolve("thorax.yaml"), "axes: LSA\n");
        assertThat(part().notes()).containsExactly("axes LSA, 10.0 mm a unit");
        assertThat(part().find("rib_03_L").orElseThrow().mesh().bounds())
                .containsExactly(ribs.get(4).mesh().bounds(), within(FILE_MM));
    }

    /** A skin of 90 cm would be a part of a trunk in mm; between stumps of the last ribs the extent counts. */
    @Test
    void theUnitOfAPartIsReadOffItsRibCage() {
        List<Structure> body = new ArrayList<>(BoxBody.structures().stream()
                .filter(s -> s.kind() != StructureKind.DIAPHRAGM)
                .toList());
        body.add(new Structure("skin", StructureKind.SKIN, 0, Side.MIDLINE, BoxBody.box(0, 0, 0, 450)));
        write(BoxBody.given(body, "LPS", 10));
        assertThat(part().notes()).containsExactly("axes LPS, 10.0 mm a unit");
        write(body.stream()
                .filter(s -> s.kind() == StructureKind.RIB)
                .map(s -> s.withMesh(
                        BoxBody.box(40 * s.side().sign(), 80, s.mesh().centre()[2], 2)))
                .toList());
        write(body.subList(body.size() - 1, body.size()));
        assertThat(part().notes()).containsExactly("axes LPS, 1.0 mm a unit");
    }

    /** Heads of ribs 44 mm apart would be a rib cage in cm, and the body 2.5 or 3.1 m long. */
    @ParameterizedTest
    @CsvSource({"11, 12, 125", "9, 12, 155"})
    void headsOfRibsAreNoRibCageInCentimetres(int first, int last, double halfSkin) {
        List<Structure> body = new ArrayList<>(BoxBody.structures().stream()
                .filter(s -> s.kind() == StructureKind.RIB && s.level() >= first && s.level() <= last)
                .map(s -> s.withMesh(
                        BoxBody.box(20 * s.side().sign(), 80, s.mesh().centre()[2], 2)))
                .toList());
        body.add(new Structure("skin", StructureKind.SKIN, 0, Side.MIDLINE, BoxBody.box(0, 0, 60, halfSkin)));
        write(body);
        assertThat(part().notes()).containsExactly("axes LPS, 1.0 mm a unit");
    }

    @Test
    void aFileThatHoldsNothingIsRefused() throws IOException {
        write(BoxBody.structures());
        Files.writeString(folder.resolve("liver.ply"), "");
        refused("liver.ply");
    }

    @Test
    void aBodyWithACoordinateBeyondAnyBodyIsRefused() throws IOException {
        List<Structure> body = BoxBody.structures();
        double[] p = body.get(0).mesh().positions().clone();
        p[0] = 1e30;
        write(body);
        write(List.of(body.get(0).withMesh(body.get(0).mesh().withPositions(p))));
        Files.writeString(folder.resolve("thorax.yaml"), "axes: LPS\nunits: mm\n");
        refused(
                body.get(0).name() + ": found a structure of 1.000e+30 mm, expected at most 3000 mm",
                "; the units of thorax.yaml may be wrong");
    }
}
