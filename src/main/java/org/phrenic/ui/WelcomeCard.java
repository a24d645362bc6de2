package org.phrenic.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/** What is seen first beside the breathing thorax: two doors, and what the program is not for. */
final class WelcomeCard extends JPanel {
    private static final int ARC = 12;

    private final JLabel[] quiet;

    /**
     * @param enter told through which door someone went
     * @param dismiss called when the card is closed without
     */
    WelcomeCard(Consumer<Arrangement> enter, Runnable dismiss) {
        super(new MigLayout(
                "insets 12 16 12 12, gap 6 4, novisualpadding", "[grow, fill, sg]16[grow, fill, sg][]", ""));
        setName("welcome");
        setOpaque(false);
        getAccessibleContext().setAccessibleName("Welcome");
        JButton liver = door(Arrangement.CLINICIAN, "Quiet, deep and held breaths, without terms of physics", enter);
        JButton tune = door(Arrangement.RESEARCHER, "Every parameter, force and plot", enter);
        JButton close = new JButton(Icons.CLOSE);
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.setToolTipText("Close this card");
        close.getAccessibleContext().setAccessibleName("Close this card");
        close.addActionListener(e -> dismiss.run());
        JLabel underLiver = new JLabel("Plain words; the needle comes with a later version");
        JLabel underTune = new JLabel("Parameters, forces and live plots");
        JLabel notice = new JLabel(Notice.TEXT);
        notice.setName("notice");
        quiet = new JLabel[] {underLiver, underTune};
        add(liver);
        add(tune);
        add(close, "aligny top, wrap");
        add(underLiver, "gapx 2");
        add(underTune, "gapx 2, wrap");
        add(notice, "span 3, gapy 6 0, gapx 2");
        colour();
    }

    private static JButton door(Arrangement arrangement, String tip, Consumer<Arrangement> enter) {
        JButton button = new JButton(arrangement.label());
        button.setName("door." + arrangement.name());
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(arrangement.label());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        button.setMargin(new java.awt.Insets(8, 18, 8, 18));
        button.addActionListener(e -> enter.accept(arrangement));
        return button;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (quiet != null) {
            colour();
        }
    }

    private void colour() {
        for (JLabel label : quiet) {
            label.setForeground(Theme.quietText());
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Panel.background"));
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, ARC, ARC);
        g.setColor(Theme.line());
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, ARC, ARC);
        g.dispose();
    }
}
