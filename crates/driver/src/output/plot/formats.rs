//! Pictures in other formats than SVG, with letters of DejaVu Sans Condensed whatever fonts the machine has.

use std::io;
use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{Options, Tree};

/// Pixels for each of the SVG's, in both directions: it stays sharp at 300 dpi on 15 cm.
const PIXELS: f32 = 2.0;
/// Pixels of a picture at most; one beyond is no picture but a fault.
const MOST_PIXELS: f32 = 1e8;

/// The fonts of pictures. Neither is looked for on the machine, so that a picture is the same everywhere.
static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
    let mut fonts = Database::new();
    for face in [dejavu::sans_condensed::regular(), dejavu::sans_condensed::bold()] {
        fonts.load_font_source(Source::Binary(Arc::new(face)));
    }
    fonts.set_sans_serif_family("DejaVu Sans");
    Arc::new(fonts)
});

/// The text of an SVG file as a PNG file with twice its pixels in both directions.
///
/// # Errors
/// [`io::ErrorKind::InvalidData`] if the text is no SVG.
pub fn png(svg: &str) -> io::Result<Vec<u8>> {
    let tree = read(svg)?;
    let size = tree.size();
    let [width, height] = [size.width(), size.height()].map(|pixels| (PIXELS * pixels).ceil());
    let pixmap = (width * height < MOST_PIXELS).then(|| Pixmap::new(width as u32, height as u32)).flatten();
    let mut pixmap = pixmap.ok_or_else(|| invalid(format!("{width} x {height} pixels")))?;
    // Where the size is no whole number of pixels, the last ones are covered in part.
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(PIXELS, PIXELS), &mut pixmap.as_mut());
    pixmap.encode_png().map_err(invalid)
}

/// The text of an SVG file as a PDF file of one page, on which a pixel of the SVG is 1/96 inch.
///
/// # Errors
/// [`io::ErrorKind::InvalidData`] if the text is no SVG.
pub fn pdf(svg: &str) -> io::Result<Vec<u8>> {
    let page = svg2pdf::PageOptions { dpi: 96.0 };
    svg2pdf::to_pdf(&read(svg)?, svg2pdf::ConversionOptions::default(), page).map_err(invalid)
}

fn read(svg: &str) -> io::Result<Tree> {
    let options = Options { font_family: "DejaVu Sans".into(), fontdb: FONTS.clone(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(invalid)
}

fn invalid(error: impl ToString) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SVG: &str = r##"<svg width="60" height="30" viewBox="0 0 60 30" xmlns="http://www.w3.org/2000/svg">
        <rect width="100%" height="100%" fill="#fff"/>
        <text x="5" y="20" font-family="Helvetica, Arial, sans-serif" font-size="16">σ M²</text></svg>"##;

    #[test]
    fn letters_are_drawn_without_a_font_of_the_machine() {
        let pixels = Pixmap::decode_png(&png(SVG).unwrap()).unwrap();
        assert_eq!((pixels.width(), pixels.height()), (120, 60));
        let dark = pixels.pixels().iter().filter(|pixel| pixel.red() < 128).count();
        // Measured: 399; none without a font.
        assert!((350..450).contains(&dark), "{dark} dark pixels");
    }

    #[test]
    fn a_page_has_the_size_of_the_picture() {
        let page = String::from_utf8_lossy(&pdf(SVG).unwrap()).into_owned();
        assert!(page.starts_with("%PDF-1."), "{page}");
        // 60 by 30 pixels of 1/96 inch in points of 1/72.
        assert!(page.contains("/MediaBox [0 0 45 22.5]"), "{page}");
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        for no_picture in ["", "<svg", "<p/>"] {
            assert_eq!(png(no_picture).unwrap_err().kind(), io::ErrorKind::InvalidData);
            assert_eq!(pdf(no_picture).unwrap_err().kind(), io::ErrorKind::InvalidData);
        }
    }
}
