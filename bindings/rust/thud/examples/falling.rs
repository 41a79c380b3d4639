//! A game loop without a window: a ball falls onto hills, in pictures that come at uneven times. Each
//! picture shows where the ball is between the last two steps.

use thud::{BodyDef, Pos, ShapeDef, Terrain, World, WorldDef};

fn main() -> thud::Result<()> {
    let mut world = World::new(&WorldDef::default())?;
    let hills: Vec<Pos> = (-20..=20).map(|x| (f64::from(x), (0.5 * f64::from(x)).sin()).into()).collect();
    let ground = world.body_create(&BodyDef::default())?;
    world.shape_create_terrain(ground, &ShapeDef::default(), &Terrain::irregular(&hills))?;
    let ball = world.body_create(&BodyDef {
        kind: thud::BODY_DYNAMIC,
        position: Pos { x: 0.5, y: 6.0 },
        ..Default::default()
    })?;
    let bouncy = ShapeDef { restitution: 0.6, ..Default::default() };
    world.shape_create_circle(ball, &bouncy, (0.0, 0.0), 0.5)?;

    // From 144 pictures a second down to 20, as on a display that cannot keep up.
    let lengths = [1.0 / 144.0, 1.0 / 60.0, 1.0 / 30.0, 1.0 / 20.0];
    let mut time = 0.0;
    for number in 0..80 {
        let seconds = lengths[number % 4];
        time += seconds;
        let (_, alpha) = world.advance(seconds, 4)?;
        for hit in world.events().hit {
            println!("         hit at {:.1} lengths a second", hit.speed);
        }
        let pose = world.poses((0.0, 0.0), alpha)?[thud::slot(ball)];
        println!("{time:5.3} s  x {:.2}  y {:.2}", pose.x, pose.y);
    }
    Ok(())
}
