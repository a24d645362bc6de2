package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * On domes whose outer and inner vertices are known, and on sheets of bodies, whose two faces must have about the same
 * area.
 */
class DiaphragmFacesTest {
    private static final double RIGHT_SHARE = 0.98;

    private static DiaphragmFaces faces(TriangleMesh sheet) {
        return new DiaphragmFaces(sheet, new MeshTopology(sheet));
    }

    private static double rightShare(TriangleMesh dome) {
        DiaphragmFaces faces = faces(dome);
        int outer = dome.vertexCount() / 2;
        int right = 0;
        for (int i = 0; i < dome.vertexCount(); i++) {
            right += faces.isThoracic(i) == i < outer ? 1 : 0;
        }
        return right / (double) dome.vertexCount();
    }

    private static double thoracicAreaShare(TriangleMesh sheet) {
        DiaphragmFaces faces = faces(sheet);
        double[] areas = MeshMeasure.vertexAreas(sheet);
        double thoracic = 0;
        double all = 0;
        for (int i = 0; i < areas.length; i++) {
            all += areas[i];
            thoracic += faces.isThoracic(i) ? areas[i] : 0;
        }
        return thoracic / all;
    }

    @Test
    void outerAndInnerVerticesOfADomeAreToldApart() {
        assertThat(rightShare(DomeSheet.adult(20))).isGreaterThanOrEqualTo(RIGHT_SHARE);
        assertThat(rightShare(DomeSheet.of(130, 90, 110, 8, 20, 0))).isGreaterThanOrEqualTo(RIGHT_SHARE);
        assertThat(rightShare(DomeSheet.of(100, 100, 60, 2, 16, 3))).isGreaterThanOrEqualTo(RIGHT_SHARE);
    }

    /** As in a scan at full inspiration: the xiphoid stands above the dome. */
    @Test
    void facesAreToldApartWhereTheBorderStandsAboveAFlatDome() {
        for (double height : new double[] {30, 60}) {
            TriangleMesh dome = DomeSheet.of(130, 90, height, 3, 20, 0);
            double[] raised = dome.positions().clone();
            for (int i = 0; i < raised.length; i += 3) {
                raised[i + 2] += 1.5 * Math.max(0, -raised[i + 1] - 20) * Math.exp(-raised[i] * raised[i] / 1600);
            }
            assertThat(rightShare(dome.withPositions(raised)))
                    .as("height %s mm", height)
                    .isGreaterThanOrEqualTo(RIGHT_SHARE);
        }
    }

    @Test
    void whereTheBodyStandsMakesNoDifference() {
        TriangleMesh dome = DomeSheet.adult(12);
        double[] moved = dome.positions().clone();
        for (int i = 0; i < moved.length; i++) {
            moved[i] += new double[] {300, -700, 1200}[i % 3];
        }
        assertThat(rightShare(dome.withPositions(moved))).isEqualTo(rightShare(dome));
    }

    @Test
    void theBorderIsWhereTheFacesMeet() {
        int rings = 20;
        DiaphragmFaces faces = faces(DomeSheet.adult(rings));
        int border = 0;
        for (int i = 0; i < faces.vertexCount(); i++) {
            border += faces.isBorder(i) ? 1 : 0;
        }
        // Both rims of 6 vertices a ring number.
        assertThat(border).isEqualTo(2 * 6 * rings);
    }

    /** A strip of 600 vertices, the first half thoracic, with an island of three in it and one of seven in the rest. */
    @Test
    void anIslandOfFewVerticesTakesTheFaceAroundIt() {
        int n = 600;
        boolean[] thoracic = new boolean[n];
        int[] edges = new int[2 * (n - 1)];
        for (int i = 0; i < n; i++) {
            boolean three = i >= 100 && i < 103;
            boolean seven = i >= 400 && i < 407;
            thoracic[i] = i < n / 2 ? !three : seven;
            if (i > 0) {
                edges[2 * i - 2] = i - 1;
                edges[2 * i - 1] = i;
            }
        }
        DiaphragmFaces.joinIslands(thoracic, edges);
        for (int i = 0; i < n; i++) {
            // Seven of 600 are more than a hundredth, so they are taken for a part of a face.
            assertThat(thoracic[i]).as("vertex %s", i).isEqualTo(i < n / 2 || i >= 400 && i < 407);
        }
    }

    /**
     * A strip whose first 100 vertices are thoracic, near the border from 90 to 110, with misread vertices from 85 to
     * 99, from 89 to 90 and from 101 to 105: only the first region reaches beyond with more than one vertex.
     */
    @Test
    void aMisreadRegionThatReachesBeyondTheBorderIsCorrected() {
        assertThat(thoracicAfterCorrection(85, 100)).isEqualTo(100);
        assertThat(thoracicAfterCorrection(89, 91)).isEqualTo(98);
        assertThat(thoracicAfterCorrection(101, 106)).isEqualTo(105);
    }

    private static int thoracicAfterCorrection(int from, int to) {
        int n = 200;
        boolean[] thoracic = new boolean[n];
        boolean[] near = new boolean[n];
        int[] edges = new int[2 * (n - 1)];
        for (int i = 0; i < n; i++) {
            thoracic[i] = i < 100 != (i >= from && i < to);
            near[i] = i >= 90 && i <= 110;
            edges[Math.max(0, 2 * i - 2)] = Math.max(0, i - 1);
            edges[Math.max(1, 2 * i - 1)] = Math.max(1, i);
        }
        DiaphragmFaces.correctRegions(thoracic, edges, near, i -> i >= from && i < to);
        int sum = 0;
        for (boolean t : thoracic) {
            sum += t ? 1 : 0;
        }
        return sum;
    }

    @Test
    void bothFacesOfTheVirtualSheetsHaveAboutEqualArea() {
        for (String body : new String[] {"adult-male", "adult-female"}) {
            TriangleMesh sheet = VirtualThorax.ofPreset(body, Resolution.LOW)
                    .find("diaphragm")
                    .orElseThrow()
                    .mesh();
            assertThat(thoracicAreaShare(sheet)).as(body).isCloseTo(0.5, within(0.05));
        }
    }

    @Test
    void bothFacesOfARealSheetHaveAboutEqualArea() {
        assertThat(thoracicAreaShare(SharedThorax.diaphragmSheet())).isCloseTo(0.5, within(0.06));
    }
}
