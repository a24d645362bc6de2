package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.fit.FitDistances;
import org.phrenic.fit.FitResult;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.scene.DistanceMapPictures;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;

/** Each target's part of the body in colours of its distance, at end-expiration and as fitted, in one scale. */
public final class FitPictures {
    private static final int SIZE = 640;
    private static final double[] ROUND_RANGES_MM = {2, 3, 5, 10, 15, 20, 30, 50, 100};

    private FitPictures() {}

    /** Draws all into a folder; none, with a line that says why, where nothing here draws. */
    public static List<Picture> draw(FitResult result, Path folder, PrintWriter err) {
        List<Picture> pictures = new ArrayList<>();
        try {
            for (FitResult.TargetResult target : result.targets()) {
                if (!target.target().isPointPairs()) {
                    draw(target, folder, pictures);
                }
            }
        } catch (NoGraphicsException none) {
            err.println("The report has no pictures: " + none.getMessage());
            return List.of();
        }
        return pictures;
    }

    private static void draw(FitResult.TargetResult target, Path folder, List<Picture> pictures)
            throws NoGraphicsException {
        ColourScale scale = scale(target.initial().summary());
        AnatomicalView[] views = target.target().part().isBase()
                ? new AnatomicalView[] {AnatomicalView.INFERIOR}
                : new AnatomicalView[] {AnatomicalView.ANTERIOR, AnatomicalView.INFERIOR};
        for (AnatomicalView view : views) {
            drawView(target.initial(), target.target().name(), "end-expiration", view, scale, folder, pictures);
            drawView(target.residual(), target.target().name(), "fitted", view, scale, folder, pictures);
        }
    }

    /** Colours from 0 to a round number that few distances exceed. */
    static ColourScale scale(DistanceSummary distances) {
        double most = distances.percentile95();
        double round = ROUND_RANGES_MM[ROUND_RANGES_MM.length - 1];
        for (int i = ROUND_RANGES_MM.length - 1; i >= 0 && ROUND_RANGES_MM[i] >= most; i--) {
            round = ROUND_RANGES_MM[i];
        }
        return ColourScale.sequential(round, ColourField.DISTANCE.unit());
    }

    private static void drawView(
            FitDistances distances,
            String name,
            String state,
            AnatomicalView view,
            ColourScale scale,
            Path folder,
            List<Picture> pictures)
            throws NoGraphicsException {
        String file = name + "_" + state + "_" + view.label() + ".png";
        String title = name + ", " + state;
        try (DistanceMapPictures drawn = DistanceMapPictures.open(distances.model(), distances.toTarget())) {
            drawn.write(folder.resolve(file), PictureSettings.of(view, SIZE, SIZE, title), scale);
        }
        pictures.add(new Picture(file, title + " seen from " + view.label(), title));
    }
}
