package org.phrenic.model.material;

import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.organ.TendonRule;

/**
 * The model of Villard, Bourne and Bello 2009 with their scheme: the springs, masses and forces of
 * {@link PaperMaterial}, the tendon above a plane, midpoint Runge-Kutta and a step of 0.01 s.
 *
 * <p>The published step is beyond the stability limit of that scheme. It is split into the least number of substeps
 * that bear it: two for the sheet, and more for sternum and cartilages, whose springs are stiffer. No force of the
 * model acts between sternum and sheet, as both follow the ribs, so each part moves as if it alone were stepped.
 */
final class PublishedMaterial extends PaperMaterial {
    PublishedMaterial() {
        super("published");
    }

    @Override
    public IntegratorKind integrator() {
        return IntegratorKind.RK2;
    }

    @Override
    public TendonRule tendonRule() {
        return TendonRule.PLANE;
    }

    @Override
    public boolean stepsSternumApart() {
        return true;
    }
}
