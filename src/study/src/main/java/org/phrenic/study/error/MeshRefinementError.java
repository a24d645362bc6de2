package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.Key;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.ReportNumbers;

/**
 * Discretization error of a coarser mesh over a breath. The diaphragm's displacement from rest at each vertex of the
 * coarser sheet is compared with the displacement of the finest sheet at the nearest point of its rest surface.
 *
 * @param resolution of the coarser sheet
 * @param referenceResolution of the finest sheet
 * @param vertices number of vertices of the coarser sheet
 * @param rmsMm rms difference of displacements, mm
 * @param maxMm maximum difference of displacements, mm
 * @param excursionDifferenceMm difference of the domes' excursion, mean of both sides, mm
 */
public record MeshRefinementError(
        String resolution,
        @Key("against") String referenceResolution,
        int vertices,
        double rmsMm,
        double maxMm,
        @Key("dome_excursion_mm") double excursionDifferenceMm) {

    /** The sheet at rest, its positions over time, and the descent of its domes, mm. */
    private record Sheet(TriangleMesh rest, double[][] moved, double excursionMm) {}

    /**
     * Compares coarser resolutions with the finest.
     *
     * @param scenarios the same scene at each resolution, coarsest first
     * @param breathS simulated time, s
     */
    static List<MeshRefinementError> of(List<Scenario> scenarios, double breathS, ProgressListener progress) {
        List<Sheet> sheets = new ArrayList<>();
        for (Scenario scenario : scenarios) {
            sheets.add(sheet(scenario, breathS));
            progress.done(sheets.size(), scenarios.size(), "mesh, " + name(scenario));
        }
        Sheet finest = sheets.get(sheets.size() - 1);
        List<MeshRefinementError> errors = new ArrayList<>();
        for (int i = 0; i < sheets.size() - 1; i++) {
            errors.add(
                    compare(sheets.get(i), finest, name(scenarios.get(i)), name(scenarios.get(scenarios.size() - 1))));
        }
        return errors;
    }

    private static String name(Scenario scenario) {
        return ReportNumbers.label(scenario.resolution());
    }

    private static Sheet sheet(Scenario scenario, double breathS) {
        try (BreathRunner runs = new BreathRunner(scenario, SimulationRun.loadThorax(scenario), breathS)) {
            Trajectory run = runs.run(SolverSettings.of(scenario));
            // The diaphragm's nodes come first, in vertex order.
            TriangleMesh mesh = runs.diaphragmAtRest();
            double[] start = runs.toCallerOrder(runs.start());
            double[][] moved = new double[run.positions().length][];
            for (int s = 0; s < moved.length; s++) {
                double[] now = runs.toCallerOrder(run.positions()[s]);
                moved[s] = new double[3 * mesh.vertexCount()];
                for (int i = 0; i < moved[s].length; i++) {
                    moved[s][i] = now[i] - start[i];
                }
            }
            return new Sheet(mesh, moved, runs.excursionMm(run));
        }
    }

    private static MeshRefinementError compare(Sheet coarse, Sheet fine, String coarseName, String fineName) {
        TriangleTree tree = new TriangleTree(fine.rest);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int vertices = coarse.rest.vertexCount();
        double sum = 0;
        double most = 0;
        for (int v = 0; v < vertices; v++) {
            tree.closest(coarse.rest.x(v), coarse.rest.y(v), coarse.rest.z(v), hit);
            int[] corners = fine.rest.triangles();
            int a = 3 * corners[3 * hit.triangle];
            int b = 3 * corners[3 * hit.triangle + 1];
            int c = 3 * corners[3 * hit.triangle + 2];
            for (int s = 0; s < coarse.moved.length; s++) {
                double[] m = fine.moved[s];
                double squared = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double there = hit.weightA * m[a + axis] + hit.weightB * m[b + axis] + hit.weightC * m[c + axis];
                    double d = coarse.moved[s][3 * v + axis] - there;
                    squared += d * d;
                }
                sum += squared;
                most = Math.max(most, squared);
            }
        }
        return new MeshRefinementError(
                coarseName,
                fineName,
                vertices,
                Math.sqrt(sum / vertices / coarse.moved.length),
                Math.sqrt(most),
                coarse.excursionMm - fine.excursionMm);
    }
}
