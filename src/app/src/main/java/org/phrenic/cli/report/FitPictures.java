package org.phrenic.cli.report;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.fit.FitDistances;
import org.phrenic.fit.FitResult;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.scene.SurfacePictures;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;

/** Pictures of each fit target, coloured by distance, at end-expiration and after the fit, with one colour scale. */
public final class FitPictures {
    private static final int SIZE = 640;
    private static final double MIN_RANGE_MM = 2;

    private FitPictures() {}

    /** Writes all pictures into a folder. Without graphics, prints the reason and returns an empty list. */
    public static List<Picture> draw(FitResult result, Path folder, PrintWriter err) {
        List<Picture> written = new ArrayList<>();
        try (SurfacePictures pictures = new SurfacePictures()) {
            for (FitResult.TargetResult target : result.targets()) {
                if (!target.target().isPointPairs()) {
                    draw(pictures, target, folder, written);
                }
            }
        } catch (NoGraphicsException none) {
            err.println("The report has no pictures: " + none.getMessage());
        }
        return written;
    }

    private static void draw(
            SurfacePictures pictures, FitResult.TargetResult target, Path folder, List<Picture> written) {
        ColourScale scale = scale(target.initial().summary());
        List<AnatomicalView> views = target.target().part().isBase()
                ? List.of(AnatomicalView.INFERIOR)
                : List.of(AnatomicalView.ANTERIOR, AnatomicalView.INFERIOR);
        for (AnatomicalView view : views) {
            for (String state : List.of("end-expiration", "fitted")) {
                FitDistances distances = state.equals("fitted") ? target.residual() : target.initial();
                String file = target.target().name() + "_" + state + "_" + view.label() + ".png";
                String title = target.target().name() + ", " + state;
                PictureSettings settings = PictureSettings.of(view, SIZE, SIZE, title);
                TriangleMesh model = distances.model();
                BufferedImage picture =
                        pictures.distances(model, distances.toTarget(), settings, scale, model.bounds());
                PngFile.write(folder.resolve(file), picture);
                written.add(new Picture(file, title + " seen from " + view.label(), title));
            }
        }
    }

    /** Colour scale from 0 to the 95th percentile of the distances, rounded up. */
    static ColourScale scale(DistanceSummary distances) {
        double range = Math.max(MIN_RANGE_MM, ColourScale.roundRange(distances.percentile95()));
        return ColourScale.sequential(range, ColourField.DISTANCE.unit());
    }
}
