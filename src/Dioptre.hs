-- |
-- Module      : Dioptre
-- Description : The whole program in one expression
--
-- A picture is a function of a text:
--
-- @
-- 'draw' = 'rendered' . 'plan' mempty 'noModels' . fst . 'checkScene' . 'parse'
-- @
--
-- Each name is a stage, and each stage is a folder; reading them in this order is a course in ray tracing.
--
-- [Source] Bytes become text with lines and columns ("Dioptre.Source.Text"). What can be wrong with a text is data
-- ("Dioptre.Source.Diagnostic"); its words stand apart, in two languages ("Dioptre.Source.Message").
--
-- [Syntax] Text becomes a tree of objects and properties ("Dioptre.Syntax.Grammar", "Dioptre.Syntax.Value").
--
-- [Scene] The tree becomes a checked scene ("Dioptre.Scene.Check"), by a description of each object
-- ("Dioptre.Scene.Schema") that also writes it back.
--
-- [Math, Geometry, Light] Vectors, roots, rays and shapes: where a ray meets a sphere is
-- "Dioptre.Math.Roots" at work in "Dioptre.Geometry.Sphere".
--
-- [Model] Models come from files of four formats to one thing ("Dioptre.Model.Content"), each once ("Dioptre.Model.Library"). A scene of text alone has 'noModels', and none of the pictures for
-- textures, which are the @mempty@.
--
-- [Render] The scene becomes a plan, and the plan rows of pixels: the camera ("Dioptre.Render.View"), the closest hit
-- among all shapes and their index ("Dioptre.Render.World", "Dioptre.Geometry.Hierarchy"), one row ("Dioptre.Render.Row"), all of them in parallel ("Dioptre.Render.Parallel").
--
-- [Picture] Colours become bytes ("Dioptre.Picture.Byte"), and bytes a file ("Dioptre.Picture.Png").
--
-- Everything so far is pure. What touches the world stands at the end: "Dioptre.Files.Whole" and its neighbours, and the commands.
--
-- As a library, in a program, which reads a scene, tells what is wrong with it, and writes its picture:
--
-- > import qualified Data.ByteString as Bytes
-- > import qualified Data.ByteString.Lazy as Lazy
-- > import Dioptre
-- >
-- > main :: IO ()
-- > main = do
-- >   source <- decode "scene.txt" <$> Bytes.readFile "scene.txt"
-- >   mapM_ (print . pretty English source) (complaints source)
-- >   Lazy.writeFile "scene.png" (encode (draw source))
--
-- (A scene that names pictures or models needs those files as well: "Dioptre.Load" reads a scene with all of them.)
--
-- And in GHCi:
--
-- >>> :set -XOverloadedStrings
-- >>> import Dioptre
-- >>> pictureWidth (draw (fromText "scene.txt" "viewport\nwidth 40\nend"))
-- 40
-- >>> map (code . diagnosticProblem) (complaints (fromText "scene.txt" "viewport\nwidht 40\nend"))
-- ["unknown-word"]
module Dioptre
  ( -- * The whole program
    draw,
    complaints,

    -- * Its stages
    decode,
    fromText,
    parse,
    checkScene,
    plan,
    noModels,
    rendered,
    encode,

    -- * What passes between them
    Source,
    Tree,
    Scene,
    Diagnostic (..),
    code,
    severity,
    pretty,
    Language (..),
    Plan,
    Picture,
    pictureWidth,
    pictureHeight,
    pictureBytes,
  )
where

import Dioptre.Model.Library (noModels)
import Dioptre.Picture (Picture, pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Picture.Png (encode)
import Dioptre.Render (rendered)
import Dioptre.Render.Row (Plan, plan)
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Diagnostic (Diagnostic (..), code, severity)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Report (pretty)
import Dioptre.Source.Text (Source, decode, fromText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.Syntax.Tree (Tree)

-- | The picture of a scene's text. Total: whatever the text, there is a picture.
draw :: Source -> Picture
draw = rendered . plan mempty noModels . fst . checkScene . parse

-- | What is wrong with a scene's text, in its order.
complaints :: Source -> [Diagnostic]
complaints = snd . checkScene . parse
